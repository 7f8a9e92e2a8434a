#pragma once

#include "base/diagnostic.h"

#include <cstddef>
#include <map>
#include <string>

/// Of one message in the window; more would only be drawn slowly.
constexpr std::size_t most_message_bytes = 2048;
/// Of one line of a file in the window.
constexpr std::size_t most_line_bytes = std::size_t{64} * 1024;

/// The lines that diagnostics speak of, each file read once.
class SourceLines {
public:
    /// The text of a diagnostic's line, shortened to most_line_bytes; "" where there is none.
    std::string line_of(const Diagnostic& diagnostic);

private:
    std::map<std::filesystem::path, std::string> m_texts;  // "": cannot be read
    std::map<std::filesystem::path, std::vector<std::string_view>> m_lines;
};
