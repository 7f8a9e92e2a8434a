#include "lab/messages/source_lines.h"

#include "base/file.h"
#include "base/printable.h"
#include "base/text.h"

std::string SourceLines::line_of(const Diagnostic& diagnostic) {
    if (diagnostic.line < 1 || diagnostic.file.empty())
        return {};
    const auto [text, is_new] = m_texts.try_emplace(diagnostic.file);
    auto& lines = m_lines[diagnostic.file];
    if (is_new) {
        text->second = read_text(diagnostic.file).value_or(std::string());
        lines = split_lines(text->second);
    }
    const auto number = static_cast<std::size_t>(diagnostic.line);
    return number <= lines.size() ? shortened(std::string(lines[number - 1]), max_line_bytes)
                                  : std::string();
}
