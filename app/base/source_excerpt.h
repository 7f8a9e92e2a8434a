#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

/// The source line of a diagnostic between its neighbours, ready to be displayed: without common
/// indentation, tabs as spaces, control characters as "\x1b", at most 200 characters a line.
struct SourceExcerpt {
    int first_line = 0;              // of `lines`, from 1
    std::vector<std::string> lines;  // up to three; empty: the line does not exist
    std::size_t index = 0;           // of the diagnostic's line in `lines`
    // The part of that line that the message is about, in bytes; empty: unknown.
    std::size_t begin = 0;
    std::size_t end = 0;

    std::string_view line() const { return lines.empty() ? std::string_view() : lines[index]; }
    bool operator==(const SourceExcerpt&) const = default;
};

/// The excerpt around line `line` (from 1). The marked part is at the "(column 12)" of the message.
/// Otherwise it is the first quoted part ('exposur') that is a name in the line, or a sign that the
/// line has once.
SourceExcerpt excerpt_of(const std::vector<std::string_view>& lines, int line,
                         std::string_view message);

/// Lines for a terminal, with numbers and a mark below the part:
///    13 | void main() {
///    14 |     float a = params.gian;
///       |                      ^~~~
std::string to_string(const SourceExcerpt& excerpt);
