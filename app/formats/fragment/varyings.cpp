#include "formats/fragment/varyings.h"

#include "base/text.h"
#include "glsl/compile/check.h"
#include "glsl/text/include.h"
#include "glsl/text/tokens.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>

namespace {
constexpr std::array qualifiers{"lowp",   "mediump",       "highp",    "flat",
                                "smooth", "noperspective", "centroid", "invariant"};

/// Macros and integer constants of a text, as far as declarations need them.
class SmallInfo {
public:
    explicit SmallInfo(const std::vector<Token>& tokens) {
        for (std::size_t i = 0; i + 2 < tokens.size(); ++i) {
            const Token& word = tokens[i + 1];
            if (tokens[i].is("define") && tokens[i].in_directive && word.in_directive)
                add_macro(word.text, tokens[i + 2]);
            else if (tokens[i].is("int") && tokens[i + 2].is("=") && i + 3 < tokens.size())
                add_number(word.text, tokens[i + 3]);
        }
    }

    bool is_in(const Token& token) const {
        return token.is("in") || token.is("varying") || m_words_for_in.contains(token.text);
    }

    bool is_qualifier(const Token& token) const {
        return std::ranges::find(qualifiers, token.text) != qualifiers.end() ||
               m_qualifiers.contains(token.text);
    }

    std::string_view number_for(std::string_view word) const {
        const auto known = m_numbers.find(word);
        return known == m_numbers.end() ? word : known->second;
    }

private:
    void add_macro(std::string_view name, const Token& value) {
        const bool is_empty = !value.in_directive || value.starts_directive;
        if (!is_empty && is_in(value))
            m_words_for_in.insert(name);
        else if (is_empty || is_qualifier(value))
            m_qualifiers.insert(name);
        else
            add_number(name, value);
    }

    void add_number(std::string_view name, const Token& value) {
        if (value.kind == Token::Kind::number)
            m_numbers.emplace(name, value.text);
    }

    std::set<std::string_view> m_words_for_in;
    std::set<std::string_view> m_qualifiers;
    std::map<std::string_view, std::string_view> m_numbers;
};

/// Parses one statement: `in highp vec2 uv, at[3]` or `in Block { vec2 uv; } name`.
class StatementReader {
public:
    StatementReader(const std::vector<Token>& words, const SmallInfo& info)
        : m_words(words), m_info(info) {}

    std::vector<FragmentVarying> varyings() {
        FragmentVarying first;
        if (!read_qualifiers(first) || m_at >= m_words.size())
            return {};
        first.type = m_words[m_at].text;
        first.line = m_words[m_at++].line;
        if (is_next("{"))
            return {block(first)};
        first.size = array_size();
        return names(first, ";");
    }

private:
    bool is_next(std::string_view sign) const {
        return m_at < m_words.size() && m_words[m_at].is(sign);
    }

    // Whether the qualifiers include `in`.
    bool read_qualifiers(FragmentVarying& varying) {
        bool is_in = false;
        for (; m_at < m_words.size(); ++m_at) {
            const Token& word = m_words[m_at];
            if (word.is("layout"))
                skip_brackets();
            else if (m_info.is_in(word))
                is_in = true;
            else if (!m_info.is_qualifier(word))
                break;
            varying.is_flat = varying.is_flat || word.is("flat");
        }
        return is_in;
    }

    void skip_brackets() {
        while (m_at + 1 < m_words.size() && !m_words[m_at].is(")"))
            ++m_at;
    }

    std::string array_size() {
        std::string size;
        bool is_open = is_next("[");
        for (; is_open && m_at < m_words.size(); ++m_at) {
            size += m_info.number_for(m_words[m_at].text);
            is_open = !m_words[m_at].is("]");
        }
        return size;
    }

    // Parses `uv, at[3];`. Each name has the attributes of `first`, except its own.
    std::vector<FragmentVarying> names(const FragmentVarying& first, std::string_view end) {
        std::vector<FragmentVarying> found;
        while (m_at < m_words.size() && m_words[m_at].kind == Token::Kind::word) {
            FragmentVarying next = first;
            next.name = m_words[m_at].text;
            next.line = m_words[m_at++].line;
            if (const std::string size = array_size(); !size.empty())
                next.size = size;
            found.push_back(std::move(next));
            while (m_at < m_words.size() && !is_next(",") && !is_next(end))
                ++m_at;
            if (!is_next(","))
                break;
            ++m_at;
        }
        if (is_next(end))
            ++m_at;
        return found;
    }

    FragmentVarying block(FragmentVarying made) {
        ++m_at;
        while (m_at < m_words.size() && !is_next("}")) {
            FragmentVarying member;
            read_qualifiers(member);
            if (m_at + 1 >= m_words.size() || m_words[m_at].kind != Token::Kind::word)
                break;
            member.type = m_words[m_at++].text;
            member.size = array_size();
            const std::vector<FragmentVarying> members = names(member, ";");
            made.members.insert(made.members.end(), members.begin(), members.end());
            if (members.empty())
                break;
        }
        m_at = std::min(m_at + 1, m_words.size());
        if (m_at < m_words.size() && m_words[m_at].kind == Token::Kind::word)
            made.name = m_words[m_at].text;
        return made;
    }

    const std::vector<Token>& m_words;
    const SmallInfo& m_info;
    std::size_t m_at = 0;
};

/// Splits a text into statements.
class VaryingFinder {
public:
    explicit VaryingFinder(std::string_view text) {
        std::vector<Token> tokens;
        for (const Token& token : scan(text).all)
            if (token.kind != Token::Kind::comment)
                tokens.push_back(token);
        const SmallInfo info(tokens);
        for (const Token& token : tokens)
            if (!token.in_directive)
                add(token, info);
    }

    std::vector<FragmentVarying> found;

private:
    void add(const Token& token, const SmallInfo& info) {
        const bool opens = token.is("(") || token.is("{") || token.is("[");
        const bool closes = token.is(")") || token.is("}") || token.is("]");
        m_is_of_in = m_is_of_in || (m_depth == 0 && info.is_in(token));
        m_depth = std::max(m_depth + (opens ? 1 : 0) - (closes ? 1 : 0), 0);
        // Ignores the content of function bodies and brackets.
        if (m_depth == 0 || opens || m_is_of_in)
            m_statement.push_back(token);
        const bool ends_code = token.is("}") && !m_is_of_in;
        if (m_depth > 0 || (!token.is(";") && !ends_code))
            return;
        if (m_is_of_in)
            for (FragmentVarying& varying : StatementReader(m_statement, info).varyings())
                if (!varying.name.starts_with("gl_") &&
                    m_names.insert(varying.name.empty() ? varying.type : varying.name).second)
                    found.push_back(std::move(varying));
        m_statement.clear();
        m_is_of_in = false;
    }

    std::vector<Token> m_statement;
    std::set<std::string> m_names;  // names in `found`
    int m_depth = 0;
    bool m_is_of_in = false;
};

/// The value of a varying, and whether its name suggests it.
struct Given {
    std::string value;
    bool is_known = true;
};

Given given_to(const FragmentVarying& varying) {
    const std::string name = to_lower(varying.name);
    const auto speaks_of = [&](std::string_view word) {
        return name.find(word) != std::string::npos;
    };
    const bool is_color = speaks_of("color") || speaks_of("colour") || speaks_of("tint");
    const bool is_place = speaks_of("uv") || speaks_of("coord") || speaks_of("tex") ||
                          speaks_of("pos") || name == "st";
    if (varying.type == "vec2")
        return {"place", is_place};
    if (varying.type == "vec3" && speaks_of("normal"))
        return {"vec3(0.0, 0.0, 1.0)", true};
    if (is_color && (varying.type == "vec3" || varying.type == "vec4"))
        return {varying.type + "(1.0)", true};
    if (varying.type == "vec3")
        return {"vec3(place, 0.0)", is_place};
    if (varying.type == "vec4")
        return {"vec4(place, 0.0, 1.0)", is_place};
    return {varying.type + "(0)", false};
}

void warn_of_guess(const FragmentVarying& varying, const std::string& value, const Location& at,
                   Diagnostics& warnings) {
    add_new(warnings,
            {at.file, at.line,
             value == "place"
                 ? fmt::format("no vertex shader sets '{}'; the texture coordinates are used",
                               varying.name)
                 : fmt::format("no vertex shader sets '{}'; {} is used", varying.name,
                               replace_all(value, "place", "uv")),
             Severity::warning});
}
/// Builds a vertex stage and tracks the source location of each line.
class VertexText {
public:
    VertexText(const Stage& stage, Diagnostics& warnings) : m_stage(stage), m_warnings(warnings) {}

    void declare(const FragmentVarying& varying) {
        std::string code;
        if (varying.members.empty())
            code = fmt::format("{}out {} {}{};\n", varying.is_flat ? "flat " : "", varying.type,
                               varying.name, varying.size);
        else
            code = fmt::format("out {} {{ ", varying.type);
        for (const FragmentVarying& member : varying.members)
            code += fmt::format("{}{} {}{}; ", member.is_flat ? "flat " : "", member.type,
                                member.name, member.size);
        if (!varying.members.empty())
            code += fmt::format("}} {};\n", varying.name);
        add(code, location_in(m_stage, varying.line));
    }

    void give(const FragmentVarying& varying, const std::string& instance = {}) {
        if (!varying.members.empty()) {
            for (const FragmentVarying& member : varying.members)
                give(member, varying.name.empty() ? "" : varying.name + '.');
            return;
        }
        const Given given = given_to(varying);
        const Location at = location_in(m_stage, varying.line);
        const std::string name = instance + varying.name;
        if (varying.size.empty())
            add(fmt::format("    {} = {};\n", name, given.value), at);
        else
            add(fmt::format("    for (int i = 0; i < {0}.length(); ++i) {0}[i] = {1};\n", name,
                            given.value),
                at);
        if (!given.is_known)
            warn_of_guess(varying, given.value, at, m_warnings);
    }

    void add(std::string_view code, const Location& at) {
        made.text.own() += code;
        made.lines.append(at, static_cast<std::size_t>(std::ranges::count(code, '\n')));
    }

    Stage made;

private:
    const Stage& m_stage;
    Diagnostics& m_warnings;
};

}  // namespace

std::vector<FragmentVarying> find_varyings(std::string_view text) {
    return VaryingFinder(text).found;
}

Stage vertex_stage_for(const std::vector<FragmentVarying>& varyings, const Stage& stage,
                       Diagnostics& warnings) {
    const Location ours{{}, 1};
    VertexText text(stage, warnings);
    text.made.file = stage.file;
    text.add("#version 410 core\n", ours);
    for (const FragmentVarying& varying : varyings)
        text.declare(varying);
    text.add(
        "void main() {\n"
        "    vec2 place = vec2((gl_VertexID << 1) & 2, gl_VertexID & 2);\n"
        "    gl_Position = vec4(place * 2.0 - 1.0, 0.0, 1.0);\n",
        ours);
    for (const FragmentVarying& varying : varyings)
        text.give(varying);
    text.add("}\n", ours);
    return std::move(text.made);
}
