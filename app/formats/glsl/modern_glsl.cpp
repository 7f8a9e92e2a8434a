#include "formats/glsl/modern_glsl.h"

#include "base/text.h"
#include "formats/glsl/reserved_words.h"
#include "glsl/text/tokens.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

namespace {
constexpr std::array<std::pair<std::string_view, std::string_view>, 16> old_functions{
    {{"texture2D", "texture"},
     {"texture3D", "texture"},
     {"textureCube", "texture"},
     {"texture2DRect", "texture"},
     {"texture2DProj", "textureProj"},
     {"texture2DLod", "textureLod"},
     {"texture2DLodEXT", "textureLod"},
     {"texture3DLod", "textureLod"},
     {"textureCubeLod", "textureLod"},
     {"textureCubeLodEXT", "textureLod"},
     {"texture2DProjLod", "textureProjLod"},
     {"texture2DProjLodEXT", "textureProjLod"},
     {"texture2DGrad", "textureGrad"},
     {"texture2DGradEXT", "textureGrad"},
     {"textureCubeGrad", "textureGrad"},
     {"textureCubeGradEXT", "textureGrad"}}};

constexpr const char* word_for_es = "afterglow_es";
constexpr int es_1 = 100;

// `float smooth =`, `vec2 layout(`: preceded by a type and followed by a token that may follow a
// name.
bool is_name_of_author(const std::vector<Token>& tokens, std::size_t at) {
    if (at == 0 || at + 1 >= tokens.size() || tokens[at].in_directive)
        return false;
    constexpr std::array<std::string_view, 6> behind_names{";", "=", ",", ")", "[", "("};
    constexpr std::array<std::string_view, 17> no_types{
        "return", "else",     "do",      "case",          "const",    "in",
        "out",    "inout",    "uniform", "lowp",          "mediump",  "highp",
        "flat",   "centroid", "smooth",  "noperspective", "invariant"};
    const Token& before = tokens[at - 1];
    if (before.is(","))  // in a list
        return tokens[at + 1].is("=") || tokens[at + 1].is(";");
    return before.kind == Token::Kind::word && !before.in_directive &&
           std::ranges::find(no_types, before.text) == no_types.end() &&
           std::ranges::find(behind_names, tokens[at + 1].text) != behind_names.end();
}

bool is_call(const std::vector<Token>& tokens, std::size_t at) {
    return at + 1 < tokens.size() && tokens[at + 1].is("(");
}

// GLSL below 4.20 has no line continuation. Joins such lines and adds the same number of empty
// lines after them.
std::string with_joined_lines(std::string_view text) {
    std::string joined;
    std::size_t pending_line_feeds = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '\\' && i + 1 < text.size() && text[i + 1] == '\n') {
            ++pending_line_feeds;
            ++i;
            continue;
        }
        joined += text[i];
        if (text[i] == '\n')
            joined.append(std::exchange(pending_line_feeds, 0), '\n');
    }
    return joined.append(pending_line_feeds, '\n');
}

class Modernising {
public:
    Modernising(std::string_view text, const WordChanges& changes, GlslVersion version)
        : m_text(text), m_changes(changes), m_version(version) {
        for (const Token& token : scan(text).all)
            if (token.kind != Token::Kind::comment)
                m_tokens.push_back(token);
        for (std::size_t i = 0; i < m_tokens.size(); ++i) {
            if (m_tokens[i].kind != Token::Kind::word)
                continue;
            m_words.insert(m_tokens[i].text);
            if (is_name_of_author(m_tokens, i))
                m_names.insert(m_tokens[i].text);
        }
    }

    std::string modern() {
        for (std::size_t i = 0; i < m_tokens.size(); ++i) {
            if (m_tokens[i].starts_directive && is_dropped(i)) {
                drop_line(i);
                continue;
            }
            if (m_tokens[i].kind == Token::Kind::word)
                put(m_tokens[i], word_for(i));
            else if (is_sign_of_macro(i))
                put(m_tokens[i], std::string(m_tokens[i].text) + ' ');
        }
        m_done.append(m_text.substr(m_at));
        return std::move(m_done);
    }

private:
    bool is_dropped(std::size_t directive) const {
        if (directive + 1 >= m_tokens.size())
            return false;
        const Token& name = m_tokens[directive + 1];
        return name.in_directive && (name.is("version") || name.is("extension") ||
                                     name.is("include") || name.is("line"));
    }

    // A driver may parse `a-b` as a decrement when b is -1.
    bool is_sign_of_macro(std::size_t at) const {
        const Token& token = m_tokens[at];
        return token.in_directive && (token.is("-") || token.is("+")) && at + 1 < m_tokens.size() &&
               m_tokens[at + 1].in_directive && m_tokens[at + 1].kind == Token::Kind::word;
    }

    // Removes all words of the directive; keeps line ends and comments.
    void drop_line(std::size_t& at) {
        put(m_tokens[at], "");
        while (at + 1 < m_tokens.size() && m_tokens[at + 1].in_directive &&
               !m_tokens[at + 1].starts_directive)
            put(m_tokens[++at], "");
    }

    std::string word_for(std::size_t at) {
        std::string word(m_tokens[at].text);
        if (const auto changed = m_changes.find(word); changed != m_changes.end())
            return changed->second;
        if (is_taken(word))
            return free_name(word);
        if (word == "GL_ES" && m_version.is_es)
            return word_for_es;
        if (word == "texture" && is_texture_of_author(at))
            return free_name(word);
        for (const auto& [old, now] : old_functions)
            if (old == word)
                return std::string(now);
        return word;
    }

    // A text without #version may also use the words of ES 3.00. In it, such a word is a name
    // only if it is declared.
    bool is_taken(std::string_view word) const {
        constexpr int usual = 330;
        const ReservedWord* const later = find_reserved_word(word);
        if (!later || later->since <= m_version.words)
            return false;
        return later->since > usual || m_names.contains(word);
    }

    bool is_texture_of_author(std::size_t at) const {
        constexpr int first_with_texture = 130;
        if (m_version.words < first_with_texture && m_names.contains("texture"))
            return true;
        return !is_call(m_tokens, at) && !m_tokens[at].in_directive;
    }

    const std::string& free_name(const std::string& word) {
        std::string& name = m_free_names[word];
        if (name.empty()) {
            name = word + '_';
            for (int other = 1; m_words.contains(name); ++other)
                name = word + (other == 1 ? "_x" : "_x" + std::to_string(other));
        }
        return name;
    }

    void put(const Token& token, std::string_view replacement) {
        const auto begin = static_cast<std::size_t>(token.text.data() - m_text.data());
        m_done.append(m_text.substr(m_at, begin - m_at));
        m_done.append(replacement);
        m_at = begin + token.text.size();
    }

    std::string_view m_text;
    const WordChanges& m_changes;
    GlslVersion m_version;
    std::vector<Token> m_tokens;
    std::set<std::string_view> m_words;
    std::set<std::string_view> m_names;               // declared in the text
    std::map<std::string, std::string> m_free_names;  // by the replaced word
    std::string m_done;
    std::size_t m_at = 0;
};
}  // namespace

GlslVersion glsl_version_of(std::string_view text) {
    const Tokens tokens = scan(text);
    for (const Directive& directive : find_directives(text, tokens)) {
        if (directive.name != "version" || directive.arguments.empty())
            continue;
        const int number = parse_integer(directive.arguments.front().text).value_or(es_1);
        const bool is_es =
            number == es_1 || (directive.arguments.size() > 1 && directive.arguments[1].is("es"));
        if (!is_es || number == es_1)
            return {number, is_es};
        return {number >= 320 ? 450 : number >= 310 ? 430 : 330, true};
    }
    return {es_1, true};
}

std::string modern_glsl(std::string_view text, const WordChanges& changes, GlslVersion version) {
    const std::string joined = with_joined_lines(text);
    return Modernising(joined, changes, version).modern();
}

void add_words(std::string_view text, GlslWords& words) {
    for (const Token& token : scan(text).all)
        if (token.kind == Token::Kind::word)
            words.emplace(token.text);
}

std::string modern_glsl_start(const GlslWords& words) {
    std::string start = "#version 410 core\n";
    if (words.contains("GL_ES"))
        start += fmt::format("#define {} 1\n", word_for_es);
    for (const char* const packing :
         {"packHalf2x16", "unpackHalf2x16", "packSnorm2x16", "unpackSnorm2x16"})
        if (words.contains(packing))
            return start + "#extension GL_ARB_shading_language_packing : enable\n";
    return start;
}
