#include "lab/inspect/source_colors.h"

#include "glsl/text/shader_names.h"
#include "glsl/text/tokens.h"

#include <algorithm>

namespace {
using Kind = CodeSpan::Kind;

bool is_code_keyword(std::string_view word) {
    const auto& keywords = glsl_keywords();
    return std::ranges::find(keywords, word) != keywords.end() || word == "if" || word == "for" ||
           word == "do" || word == "in" || word == "out";
}

Kind kind_of(const Token& token, std::string_view after) {
    if (token.kind == Token::Kind::comment)
        return Kind::comment;
    if (token.in_directive)
        return Kind::directive;
    if (token.kind == Token::Kind::number)
        return Kind::number;
    if (token.kind != Token::Kind::word)
        return Kind::plain;
    if (is_glsl_type(token.text))
        return Kind::type;
    if (is_code_keyword(token.text))
        return Kind::keyword;
    return after.substr(std::min(after.find_first_not_of(" \t"), after.size())).starts_with('(')
               ? Kind::call
               : Kind::plain;
}

// Adds a span; joins it with the last one of the same kind.
void add_span(std::vector<CodeSpan>& spans, std::size_t end, Kind kind) {
    const std::size_t begin = spans.empty() ? 0 : spans.back().end;
    if (begin >= end)
        return;
    if (!spans.empty() && spans.back().kind == kind)
        spans.back().end = end;
    else
        spans.push_back({begin, end, kind});
}
}  // namespace

std::vector<CodeSpan> code_spans(std::string_view line, bool starts_in_comment) {
    std::vector<CodeSpan> spans;
    std::size_t start = 0;
    if (starts_in_comment) {
        const std::size_t close = line.find("*/");
        start = close == std::string_view::npos ? line.size() : close + 2;
        add_span(spans, start, Kind::comment);
    }
    const std::string_view code = line.substr(start);
    const Tokens tokens = scan(code);
    for (const Token& token : tokens.all) {
        const auto begin = start + static_cast<std::size_t>(token.text.data() - code.data());
        const std::size_t end = begin + token.text.size();
        const Kind kind = kind_of(token, line.substr(end));
        add_span(spans, begin, kind == Kind::directive ? kind : Kind::plain);
        add_span(spans, end, kind);
    }
    add_span(spans, line.size(), Kind::plain);
    return spans;
}

std::vector<bool> lines_in_comments(const std::vector<std::string_view>& lines) {
    std::vector<bool> answers;
    answers.reserve(lines.size());
    bool is_open = false;
    for (const std::string_view line : lines) {
        answers.push_back(is_open);
        for (std::size_t at = 0; at < line.size();) {
            const std::size_t next = is_open ? line.find("*/", at) : line.find_first_of('/', at);
            if (next == std::string_view::npos)
                break;
            if (is_open)
                is_open = false;
            else if (line.substr(next, 2) == "/*")
                is_open = true;
            else if (line.substr(next, 2) == "//")
                break;
            else {
                at = next + 1;
                continue;
            }
            at = next + 2;
        }
    }
    return answers;
}
