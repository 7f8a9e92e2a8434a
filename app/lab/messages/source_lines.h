#pragma once

#include "base/diagnostic.h"

#include <cstddef>
#include <map>
#include <string>

/// Limit for one message in the window. Longer ones would be slow to draw.
constexpr std::size_t max_message_bytes = 2048;
/// Limit for one line of a file in the window.
constexpr std::size_t max_line_bytes = std::size_t{64} * 1024;

/// The source lines of diagnostics. Each file is read only once.
class SourceLines {
public:
    /// The line of a diagnostic, shortened to max_line_bytes; "": the line does not exist.
    std::string line_of(const Diagnostic& diagnostic);

private:
    std::map<std::filesystem::path, std::string> m_texts;  // "": not readable
    std::map<std::filesystem::path, std::vector<std::string_view>> m_lines;
};
