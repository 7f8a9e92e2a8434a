#include "formats/isf/body.h"

#include "formats/later_words.h"
#include "glsl/tokens.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>

namespace {
const std::string own_prefix = "isf_own_";

// An author of before may have used them as names.
bool is_later(std::string_view word, LaterWord::Kind kind) {
    constexpr int first_too_late = 400;
    const LaterWord* const later = find_later_word(word);
    return later && later->kind == kind && later->since >= first_too_late;
}

const std::map<std::string_view, std::string_view>& former_names() {
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
        for (const Token& token : m_tokens.all) {
            const std::string other = replacement(token);
            const std::size_t begin = place_of(token);
            if (other.empty() || blanked[begin] == ' ')
                continue;
            result += blanked.substr(copied, begin - copied) + other;
            copied = begin + token.text.size();
        }
        return result + blanked.substr(copied);
    }

private:
    std::size_t place_of(const Token& token) const {
        return static_cast<std::size_t>(token.text.data() - m_text.data());
    }

    void drop_comments() {
        std::erase_if(m_tokens.all,
                      [](const Token& token) { return token.kind == Token::Kind::comment; });
    }

    // "uniform TYPE NAME;" of a name that the program declares.
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
                blank_out(text, place_of(all[i]), place_of(all[name + 1]) + 1);
        }
    }

    // A word before and a bracket behind: "float noise1(".
    void find_own_functions() {
        const std::vector<Token>& all = m_tokens.all;
        for (std::size_t i = 1; i + 1 < all.size(); ++i)
            if (is_later(all[i].text, LaterWord::Kind::function) && all[i + 1].is("(") &&
                all[i - 1].kind == Token::Kind::word && !all[i - 1].is("return"))
                m_own.insert(all[i].text);
    }

    std::string replacement(const Token& token) const {
        if (token.kind != Token::Kind::word)
            return {};
        if (token.is("varying"))
            return m_stage == IsfStage::vertex ? "out" : "in";
        if (const auto former = former_names().find(token.text); former != former_names().end())
            return std::string(former->second);
        if (m_own.contains(token.text))
            return own_prefix + std::string(token.text);
        const std::string word = isf_word(token.text);
        return word == token.text ? std::string() : word;
    }

    std::string_view m_text;
    Tokens m_tokens;
    IsfStage m_stage;
    const std::vector<std::string>& m_declared;
    std::set<std::string_view> m_own;
};
}  // namespace

std::string isf_word(std::string_view word) {
    return (is_later(word, LaterWord::Kind::keyword) ? own_prefix : std::string()) +
           std::string(word);
}

std::string_view isf_author_word(std::string_view word) {
    return word.starts_with(own_prefix) ? word.substr(own_prefix.size()) : word;
}

std::string isf_body(std::string_view code, IsfStage stage,
                     const std::vector<std::string>& declared) {
    return BodyText(code, stage, declared).translate();
}
