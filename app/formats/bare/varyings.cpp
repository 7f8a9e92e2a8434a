#include "formats/bare/varyings.h"

#include "base/text.h"
#include "glsl/check.h"
#include "glsl/include.h"
#include "glsl/tokens.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>

namespace {
constexpr std::array qualifiers{"lowp",   "mediump",       "highp",    "flat",
                                "smooth", "noperspective", "centroid", "invariant"};

/// Cuts a text into the statements that stand in no brackets.
class VaryingFinder {
public:
    explicit VaryingFinder(std::string_view text) {
        for (const Token& token : scan(text).all)
            if (token.kind != Token::Kind::comment && !token.in_directive)
                add(token);
    }

    std::vector<BareVarying> found;

private:
    void add(const Token& token) {
        m_depth += token.is("(") || token.is("{") || token.is("[") ? 1 : 0;
        if (m_depth == 0 && (token.is(";") || token.is(",")))
            read(token.is(","));
        else if (m_depth == 0)
            m_words.push_back(token);
        const bool closes = token.is(")") || token.is("}") || token.is("]");
        m_depth = std::max(m_depth - (closes ? 1 : 0), 0);
        if (m_depth == 0 && token.is("}"))
            m_words.clear();
    }

    // `in highp vec2 uv`, or after a comma the next name of the same type.
    void read(bool goes_on) {
        std::vector<Token> kept;  // for the next name
        BareVarying varying;
        bool is_varying = false;
        std::vector<Token> rest;
        for (const Token& word : m_words) {
            is_varying = is_varying || word.is("in") || word.is("varying");
            varying.is_flat = varying.is_flat || word.is("flat");
            const bool is_qualifier = word.is("in") || word.is("varying") || word.is("layout") ||
                                      std::ranges::find(qualifiers, word.text) != qualifiers.end();
            if (word.kind == Token::Kind::word && !is_qualifier)
                rest.push_back(word);
            if (is_qualifier || rest.size() == 1)
                kept.push_back(word);
        }
        if (is_varying && rest.size() >= 2) {
            varying.type = rest[0].text;
            varying.name = rest[1].text;
            varying.line = rest[1].line;
            if (m_names.insert(rest[1].text).second)
                found.push_back(varying);
        }
        m_words.clear();
        if (goes_on && is_varying && rest.size() >= 2)
            m_words = std::move(kept);
    }

    std::vector<Token> m_words;
    std::set<std::string_view> m_names;  // of `found`
    int m_depth = 0;
};

/// What a varying is given, and whether its name says so.
struct Given {
    std::string value;
    bool is_known = true;
};

Given given_to(const BareVarying& varying) {
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

void warn_of_guess(const BareVarying& varying, const std::string& value, const Location& at,
                   Diagnostics& warnings) {
    add_new(warnings,
            {at.file, at.line,
             fmt::format("'{}' comes from a vertex shader, which is not here: it is {}",
                         varying.name, value == "place" ? "the place in the picture" : value),
             Severity::warning});
}
}  // namespace

std::vector<BareVarying> find_varyings(std::string_view text) {
    return VaryingFinder(text).found;
}

Stage vertex_stage_for(const std::vector<BareVarying>& varyings, const Stage& stage,
                       Diagnostics& warnings) {
    Stage made{stage.file, "#version 410 core\n", {{{}, 1}}};
    Stage body{{},
               "void main() {\n"
               "    vec2 place = vec2((gl_VertexID << 1) & 2, gl_VertexID & 2);\n"
               "    gl_Position = vec4(place * 2.0 - 1.0, 0.0, 1.0);\n",
               {}};
    for (const BareVarying& varying : varyings) {
        const Given given = given_to(varying);
        const Location at = place_in(stage, varying.line);
        made.text += fmt::format("{}out {} {};\n", varying.is_flat ? "flat " : "", varying.type,
                                 varying.name);
        made.lines.push_back(at);
        body.text += fmt::format("    {} = {};\n", varying.name, given.value);
        body.lines.push_back(at);
        if (!given.is_known)
            warn_of_guess(varying, given.value, at, warnings);
    }
    made.text += body.text + "}\n";
    made.lines.append({{}, 1}, 3);
    for (std::size_t i = 0; i < varyings.size(); ++i)
        made.lines.push_back(body.lines[i]);
    made.lines.push_back({{}, 1});
    return made;
}
