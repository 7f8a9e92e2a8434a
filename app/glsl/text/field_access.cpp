#include "glsl/text/field_access.h"

#include "glsl/text/tokens.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace {
using CodeTokens = std::vector<Token>;

// The index of the bracket that opens the one at `close`; 0 if there is none.
std::size_t opening_bracket(const CodeTokens& tokens, std::size_t close) {
    int depth = 0;
    for (std::size_t i = close + 1; i-- > 0;) {
        if (tokens[i].is(")") || tokens[i].is("]"))
            ++depth;
        else if (tokens[i].is("(") || tokens[i].is("["))
            --depth;
        if (depth == 0)
            return i;
    }
    return 0;
}

std::string field_type(const std::string& type, std::string_view field, const ShaderNames& names) {
    const StructName* owner = names.find_struct(type);
    if (!owner)
        return {};
    const auto found = std::ranges::find(owner->fields, field, &TypedName::name);
    return found == owner->fields.end() ? std::string() : found->type;
}

// The type of the expression that ends with token `last`, which is a name or a closing bracket.
std::string type_of(const CodeTokens& tokens, std::size_t last, const ShaderNames& names) {
    while (last > 0 && tokens[last].is("]")) {
        const std::size_t open = opening_bracket(tokens, last);
        if (open == 0)
            return {};
        last = open - 1;
    }
    const bool is_call = tokens[last].is(")");
    if (is_call) {
        const std::size_t open = opening_bracket(tokens, last);
        if (open == 0)
            return {};
        last = open - 1;
    }
    if (tokens[last].kind != Token::Kind::word)
        return {};
    const std::string name(tokens[last].text);
    if (last >= 2 && tokens[last - 1].is("."))
        return field_type(type_of(tokens, last - 2, names), name, names);
    if (is_call) {
        const FunctionName* function = names.find_function(name);
        return function                                        ? function->type
               : names.find_struct(name) || is_glsl_type(name) ? name
                                                               : "";
    }
    const TypedName* variable = names.find_variable(name);
    return variable ? variable->type : std::string();
}
}  // namespace

std::string type_before_field(std::string_view text, int line, std::string_view field,
                              const ShaderNames& names) {
    CodeTokens tokens;
    const Tokens all = scan(text);
    for (const Token& token : all.all) {
        if (token.line > line)
            break;
        if (token.kind == Token::Kind::comment || token.in_directive)
            continue;
        tokens.push_back(token);
        const std::size_t last = tokens.size() - 1;
        if (token.line == line && token.is(field) && last >= 2 && tokens[last - 1].is(".")) {
            const std::string type = type_of(tokens, last - 2, names);
            if (!type.empty())
                return type;
        }
    }
    return {};
}
