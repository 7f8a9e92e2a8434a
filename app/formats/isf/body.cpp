#include "formats/isf/body.h"

#include "formats/glsl/reserved_words.h"
#include "glsl/text/tokens.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>

namespace {
const std::string own_prefix = "isf_own_";

// An older shader may use such a word as a name.
bool is_reserved_later(std::string_view word, ReservedWord::Kind kind) {
    constexpr int first_too_late = 400;
    const ReservedWord* const later = find_reserved_word(word);
    return later && later->kind == kind && later->since >= first_too_late;
}

// Words of the language that an input may also be called: keywords since GLSL 1.30, and functions.
const std::set<std::string_view>& language_words() {
    static const std::set<std::string_view> all{
        "abs",          "acos",        "all",           "any",           "asin",
        "atan",         "case",        "ceil",          "clamp",         "cos",
        "cross",        "default",     "degrees",       "determinant",   "dFdx",
        "dFdy",         "distance",    "dot",           "equal",         "exp",
        "exp2",         "faceforward", "flat",          "floor",         "fract",
        "fwidth",       "greaterThan", "inverse",       "inversesqrt",   "isinf",
        "isnan",        "layout",      "length",        "lessThan",      "log",
        "log2",         "main",        "max",           "min",           "mix",
        "mod",          "modf",        "noperspective", "normalize",     "not",
        "outerProduct", "pow",         "radians",       "reflect",       "refract",
        "round",        "sign",        "sin",           "smooth",        "smoothstep",
        "sqrt",         "step",        "switch",        "tan",           "texelFetch",
        "texture",      "texture2D",   "texture2DLod",  "texture2DProj", "texture2DRect",
        "textureCube",  "textureGrad", "textureLod",    "textureProj",   "textureSize",
        "transpose",    "trunc",       "uint",          "uvec2",         "uvec3",
        "uvec4"};
    return all;
}

const std::map<std::string_view, std::string_view>& old_names() {
    static const std::map<std::string_view, std::string_view> all{
        {"gl_FragColor", "isf_FragColor"},
        {"vv_FragNormCoord", "isf_FragNormCoord"},
        {"vv_vertShaderInit", "isf_vertShaderInit"},
        {"texture2D", "texture"},
        {"texture2DRect", "texture"},
        {"textureCube", "texture"},
        {"texture2DLod", "textureLod"},
        {"texture2DProj", "textureProj"},
        {"attribute", "in"}};
    return all;
}

class BodyText {
public:
    BodyText(std::string_view code, IsfStage stage, const std::vector<std::string>& declared)
        : m_text(code), m_tokens(scan(code)), m_stage(stage), m_declared(declared) {}

    std::string translate() {
        std::string blanked(m_text);
        for (const Directive& directive : find_directives(m_text, m_tokens))
            if (directive.name == "version" || directive.name == "extension")
                blank_out(blanked, directive.begin, directive.end);
        drop_comments();
        blank_declarations(blanked);
        find_own_functions();
        std::string result;
        std::size_t copied = 0;
        for (std::size_t i = 0; i < m_tokens.all.size(); ++i) {
            const Token& token = m_tokens.all[i];
            const std::string other = replacement(i);
            const std::size_t begin = offset_of(token);
            if (other.empty() || blanked[begin] == ' ')
                continue;
            result += blanked.substr(copied, begin - copied) + other;
            copied = begin + token.text.size();
        }
        return result + blanked.substr(copied);
    }

private:
    std::size_t offset_of(const Token& token) const {
        return static_cast<std::size_t>(token.text.data() - m_text.data());
    }

    void drop_comments() {
        std::erase_if(m_tokens.all,
                      [](const Token& token) { return token.kind == Token::Kind::comment; });
    }

    // Blanks out "uniform TYPE NAME;" for names that the program declares.
    void blank_declarations(std::string& text) const {
        const std::vector<Token>& all = m_tokens.all;
        for (std::size_t i = 0; i + 3 < all.size(); ++i) {
            std::size_t name = i + 2;
            const bool is_varying = all[i].is("varying") || all[i].is("in") || all[i].is("out");
            if (!all[i].is("uniform") && !is_varying)
                continue;
            if (all[i + 1].is("lowp") || all[i + 1].is("mediump") || all[i + 1].is("highp"))
                ++name;
            if (name + 1 < all.size() && all[name + 1].is(";") &&
                std::ranges::find(m_declared, all[name].text) != m_declared.end())
                blank_out(text, offset_of(all[i]), offset_of(all[name + 1]) + 1);
        }
    }

    // Finds definitions such as "float noise1(".
    void find_own_functions() {
        const std::vector<Token>& all = m_tokens.all;
        for (std::size_t i = 1; i + 1 < all.size(); ++i)
            if (is_reserved_later(all[i].text, ReservedWord::Kind::function) &&
                all[i + 1].is("(") && all[i - 1].kind == Token::Kind::word &&
                !all[i - 1].is("return"))
                m_own.insert(all[i].text);
    }

    // Distinguishes an input from a function with the same name. An input cannot be called.
    bool is_declared_input(std::size_t index) const {
        const std::vector<Token>& all = m_tokens.all;
        const bool is_called = index + 1 < all.size() && all[index + 1].is("(");
        const bool is_member = index > 0 && all[index - 1].is(".");
        return language_words().contains(all[index].text) && !is_called && !is_member &&
               std::ranges::find(m_declared, all[index].text) != m_declared.end();
    }

    std::string replacement(std::size_t index) const {
        const Token& token = m_tokens.all[index];
        if (token.kind != Token::Kind::word)
            return {};
        if (is_declared_input(index))
            return own_prefix + std::string(token.text);
        if (token.is("varying"))
            return m_stage == IsfStage::vertex ? "out" : "in";
        if (const auto renamed = old_names().find(token.text); renamed != old_names().end())
            return std::string(renamed->second);
        if (m_own.contains(token.text))
            return own_prefix + std::string(token.text);
        return is_reserved_later(token.text, ReservedWord::Kind::keyword)
                   ? own_prefix + std::string(token.text)
                   : std::string();
    }

    std::string_view m_text;
    Tokens m_tokens;
    IsfStage m_stage;
    const std::vector<std::string>& m_declared;
    std::set<std::string_view> m_own;
};
}  // namespace

std::string isf_declared_name(std::string_view name) {
    const bool is_taken =
        is_reserved_later(name, ReservedWord::Kind::keyword) || language_words().contains(name);
    return (is_taken ? own_prefix : std::string()) + std::string(name);
}

std::string_view isf_author_word(std::string_view word) {
    return word.starts_with(own_prefix) ? word.substr(own_prefix.size()) : word;
}

std::string isf_body(std::string_view code, IsfStage stage,
                     const std::vector<std::string>& declared) {
    return BodyText(code, stage, declared).translate();
}
