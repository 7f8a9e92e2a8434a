#include "glsl/compile/version_line.h"

#include "base/text.h"
#include "glsl/compile/check.h"
#include "glsl/text/tokens.h"

#include <fmt/format.h>

#include <algorithm>

namespace {
constexpr int oldest = 330;

Diagnostics problem(const Stage& stage, int line, std::string message) {
    const Location at = location_in(stage, line);
    return {{at.file, at.line, std::move(message)}};
}
}  // namespace

Diagnostics check_version(const Stage& stage) {
    const Tokens tokens = scan(stage.text);
    const auto first = std::ranges::find_if(
        tokens.all, [](const Token& token) { return token.kind != Token::Kind::comment; });
    if (first == tokens.all.end())
        return problem(stage, 1, "the shader is empty; its first line must be '#version 410 core'");
    const std::vector<Directive> directives = find_directives(stage.text, tokens);
    if (!first->starts_directive || directives.front().name != "version")
        return problem(stage, first->line, "the shader's first line must be '#version 410 core'");

    const auto& words = directives.front().arguments;
    const auto number = words.empty() ? std::nullopt : parse_integer(words.front().text);
    if (!number || *number < oldest)
        return problem(
            stage, first->line,
            fmt::format("use '#version 410 core'; versions below {} aren't supported", oldest));
    if (words.size() > 1 && !words[1].is("core"))
        return problem(stage, first->line,
                       fmt::format("use '#version 410 core'; the profile '{}' isn't supported",
                                   words[1].text));
    return {};
}

std::string with_nested_arrays(std::string text) {
    const std::size_t begin = text.find("#extension GL_ARB_arrays_of_arrays");
    if (begin == text.npos)
        return text;
    text.erase(begin, text.find('\n', begin) - begin);
    return replace_all(text, "#version 410", "#version 430");
}
