#pragma once

#include "base/diagnostic.h"
#include "base/source_excerpt.h"

#include <cstddef>
#include <map>
#include <string>

/// Limit for one message in the window. Longer ones would be slow to draw.
constexpr std::size_t max_message_bytes = 2048;
/// The source lines of diagnostics. Each file is read only once.
class SourceLines {
public:
    /// The line of a diagnostic and its neighbours; empty if the line does not exist.
    SourceExcerpt excerpt_of(const Diagnostic& diagnostic);

private:
    std::map<std::filesystem::path, std::string> m_texts;  // "": not readable
    std::map<std::filesystem::path, std::vector<std::string_view>> m_lines;
};

/// Diagnostics for a terminal: "file:line: error: message", followed by the source lines.
std::string with_source_lines(const Diagnostics& diagnostics);
