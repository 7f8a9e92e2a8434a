#pragma once

#include "model/tuning/moves.h"

#include <filesystem>
#include <string_view>

/// Parses an automation file: lines of `seconds name value`, with values as for `--set`. Empty
/// lines and lines starting with # are skipped. Errors with their line: unknown names, invalid
/// values, and times earlier than the previous line's.
Result<Moves> parse_moves(std::string_view text, const std::filesystem::path& file,
                          const Look& look);
Result<Moves> load_moves(const std::filesystem::path& file, const Look& look);

/// The text that parse_moves() reads as the same moves, with a resolution of 1e-6 s.
std::string moves_text(const Moves& moves, const Look& look);
