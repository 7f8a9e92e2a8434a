#include "glsl/text/uniform_lines.h"

#include "glsl/text/declarations.h"
#include "glsl/text/tokens.h"

#include <glslang/Public/ResourceLimits.h>

#include <algorithm>

namespace {
// Adds the declarations of a text; false when a name occurs twice.
bool add_lines(const std::string& text, std::map<std::string, int>& lines) {
    bool are_unique = true;
    for (const Declaration& declaration : find_declarations(text))
        are_unique = lines.emplace(declaration.name, declaration.line).second && are_unique;
    return are_unique;
}

bool has_uniform_in_macro(const std::string& text) {
    const Tokens tokens = scan(text);
    return std::ranges::any_of(
        tokens.all, [](const Token& token) { return token.in_directive && token.is("uniform"); });
}
}  // namespace

std::map<std::string, int> find_uniform_lines(const std::string& text, EShLanguage language) {
    std::map<std::string, int> lines;
    if (add_lines(text, lines) && !has_uniform_in_macro(text))
        return lines;

    glslang::TShader shader(language);
    const char* const piece = text.c_str();
    shader.setStrings(&piece, 1);
    glslang::TShader::ForbidIncluder no_includes;
    std::string preprocessed;
    std::map<std::string, int> active;
    if (shader.preprocess(GetDefaultResources(), 410, ECoreProfile, false, false, EShMsgDefault,
                          &preprocessed, no_includes))
        add_lines(preprocessed, active);
    active.merge(lines);
    return active;
}
