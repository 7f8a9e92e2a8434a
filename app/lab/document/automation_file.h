#pragma once

#include "model/tuning/automation.h"

#include <filesystem>
#include <string_view>

/// Parses an automation file: lines of `seconds name value`, with values as for `--set`. Empty
/// lines and lines starting with # are skipped. Errors with their line: unknown names, invalid
/// values, and times earlier than the previous line's.
Result<AutomationPoints> parse_automation(std::string_view text, const std::filesystem::path& file,
                                          const Look& look);
Result<AutomationPoints> load_automation(const std::filesystem::path& file, const Look& look);

/// The text that parse_automation() reads as the same points, with a resolution of 1e-6 s.
std::string automation_text(const AutomationPoints& points, const Look& look);
