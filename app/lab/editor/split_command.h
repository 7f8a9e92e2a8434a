#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// Splits a command into words like a POSIX shell (2.2 Quoting): blanks separate; '…', "…" and
/// backslash quote. Variables, patterns and `~` are not expanded. nullopt: an unterminated quote.
std::optional<std::vector<std::string>> split_command(std::string_view text);
