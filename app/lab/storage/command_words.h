#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// The words of a command as a POSIX shell reads them (2.2 Quoting), of which nothing else is done:
/// no variable, pattern or `~` is replaced. Blanks separate, '…' and "…" and a backslash quote.
/// Nothing where a quote never ends.
std::optional<std::vector<std::string>> split_command(std::string_view text);
