#include "formats/web/compact_glsl.h"

#include "base/text.h"
#include "glsl/text/tokens.h"

#include <cmath>
#include <cstdlib>

namespace {
// With a point or an exponent, as GLSL needs for a float.
std::string short_number(std::string_view written) {
    const bool is_float = written.find_first_of(".eE") != written.npos &&
                          !written.starts_with("0x") && !written.starts_with("0X");
    if (!is_float)
        return std::string(written);
    const float number = std::strtof(std::string(written).c_str(), nullptr);
    std::string text = format_float(number);
    if (!std::isfinite(number) || std::strtof(text.c_str(), nullptr) != number)
        return std::string(written);
    if (text.find_first_of(".e") == text.npos)
        text += ".0";
    return text.size() < written.size() ? text : std::string(written);
}

bool is_word(const Token& token) {
    return token.kind == Token::Kind::word || token.kind == Token::Kind::number;
}

// "a - -b" and "a + +b" need their blank.
bool needs_blank(const Token& before, const Token& token) {
    const bool are_signs = before.is(token.text) && (token.is("-") || token.is("+"));
    const bool were_apart = before.text.data() + before.text.size() != token.text.data();
    return (is_word(before) && is_word(token)) || (are_signs && were_apart);
}
// What separates two tokens: a line end, a blank, or nothing.
std::string_view between(const Token& before, const Token& token) {
    const bool were_apart = before.text.data() + before.text.size() != token.text.data();
    if (token.starts_directive || (before.in_directive && !token.in_directive))
        return "\n";
    const bool is_in_one_line = token.in_directive && before.line == token.line;
    return (is_in_one_line && were_apart) || needs_blank(before, token) ? " " : "";
}
}  // namespace

std::string compact_glsl(std::string_view text) {
    std::string result;
    const Token* before = nullptr;
    const Tokens tokens = scan(text);
    int depth = 0;
    for (const Token& token : tokens.all) {
        if (token.kind == Token::Kind::comment)
            continue;
        if (before)
            result += between(*before, token);
        result += token.kind == Token::Kind::number && !token.in_directive
                      ? short_number(token.text)
                      : std::string(token.text);
        depth += token.is("{") ? 1 : token.is("}") ? -1 : 0;
        before = &token;
        if (depth == 0 && token.is("}")) {
            result += '\n';
            before = nullptr;
        }
    }
    return result + '\n';
}
