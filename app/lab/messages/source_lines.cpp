#include "lab/messages/source_lines.h"

#include "base/file.h"
#include "base/text.h"

SourceExcerpt SourceLines::excerpt_of(const Diagnostic& diagnostic) {
    if (diagnostic.line < 1 || diagnostic.file.empty())
        return {};
    const auto [text, is_new] = m_texts.try_emplace(diagnostic.file);
    auto& lines = m_lines[diagnostic.file];
    if (is_new) {
        text->second = read_text(diagnostic.file).value_or(std::string());
        lines = split_lines(text->second);
    }
    return ::excerpt_of(lines, diagnostic.line, diagnostic.message);
}

std::string with_source_lines(const Diagnostics& diagnostics) {
    SourceLines lines;
    std::string text;
    for (const Diagnostic& diagnostic : diagnostics)
        text += to_string(diagnostic) + '\n' + to_string(lines.excerpt_of(diagnostic));
    return text;
}
