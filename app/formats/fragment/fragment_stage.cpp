#include "formats/fragment/fragment_stage.h"

#include "formats/fragment/host_names.h"
#include "formats/glsl/modern_glsl.h"
#include "glsl/text/tokens.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace {
/// A predeclared name of versions before 1.30 and its replacement.
struct OldName {
    std::string_view old;
    std::string_view now;
    std::string_view declaration = {};
};

constexpr auto old_names = std::to_array<OldName>({
    {"gl_FragColor", "afterglow_color", "out vec4 afterglow_color;"},
    {"gl_FragData", "afterglow_data", "out vec4 afterglow_data[8];"},
    {"gl_TexCoord", "afterglow_texcoord", "in vec4 afterglow_texcoord[8];"},
    {"gl_Color", "vec4(1.0)"},
    {"gl_SecondaryColor", "vec4(0.0)"},
    {"gl_FogFragCoord", "0.0"},
    {"gl_ModelViewMatrix", "mat4(1.0)"},
    {"gl_ProjectionMatrix", "mat4(1.0)"},
    {"gl_ModelViewProjectionMatrix", "mat4(1.0)"},
    {"gl_NormalMatrix", "mat3(1.0)"},
});

/// Removes locations and bindings, used by other programs, from layout qualifiers.
class LayoutCleaner {
public:
    explicit LayoutCleaner(std::string_view text) : m_text(text) {
        for (const Token& token : scan(text).all)
            if (token.kind != Token::Kind::comment)
                m_tokens.push_back(token);
    }

    std::string clean() {
        for (std::size_t i = 0; i + 1 < m_tokens.size(); ++i)
            if (m_tokens[i].is("layout") && m_tokens[i + 1].is("(") && !m_tokens[i].in_directive)
                clean_one(i);
        return m_done.append(m_text.substr(m_at));
    }

private:
    // Outputs keep their locations, which identify the picture.
    bool is_of_input_or_uniform(std::size_t behind) const {
        for (std::size_t i = behind; i < m_tokens.size(); ++i) {
            if (m_tokens[i].is("in") || m_tokens[i].is("uniform"))
                return true;
            if (m_tokens[i].kind != Token::Kind::word || m_tokens[i].is("out"))
                return false;
        }
        return false;
    }

    void clean_one(std::size_t layout) {
        constexpr std::array<std::string_view, 4> numbers{"location", "binding", "set",
                                                          "component"};
        std::vector<std::string> remaining;
        std::size_t from = layout + 2;
        std::size_t at = from;
        for (int depth = 0; at < m_tokens.size(); ++at) {
            depth += m_tokens[at].is("(") ? 1 : 0;
            const bool ends = depth == 0 && m_tokens[at].is(")");
            depth -= m_tokens[at].is(")") ? 1 : 0;
            if (!ends && (depth > 0 || !m_tokens[at].is(",")))
                continue;
            const bool is_number =
                from < at && std::ranges::find(numbers, m_tokens[from].text) != numbers.end();
            if (from < at && !is_number)
                remaining.emplace_back(between(from, at));
            from = at + 1;
            if (ends)
                break;
        }
        if (at >= m_tokens.size() || !is_of_input_or_uniform(at + 1))
            return;
        const std::size_t begin = offset_of(layout);
        m_done.append(m_text.substr(m_at, begin - m_at));
        if (!remaining.empty())
            m_done += fmt::format("layout({})", fmt::join(remaining, ", "));
        const std::size_t end = offset_of(at) + 1;
        const std::string_view gone = m_text.substr(begin, end - begin);
        m_done.append(static_cast<std::size_t>(std::ranges::count(gone, '\n')), '\n');
        m_at = end;
    }

    std::size_t offset_of(std::size_t token) const {
        return static_cast<std::size_t>(m_tokens[token].text.data() - m_text.data());
    }

    // Joins tokens on one line.
    std::string between(std::size_t first, std::size_t end) const {
        std::string text;
        for (std::size_t i = first; i < end; ++i)
            text += fmt::format("{}{}", text.empty() ? "" : " ", m_tokens[i].text);
        return text;
    }

    std::string_view m_text;
    std::vector<Token> m_tokens;
    std::string m_done;
    std::size_t m_at = 0;
};

std::string start_of(const GlslWords& words, const std::string& text, std::string_view define) {
    std::string start = modern_glsl_start(words);
    // Features of 4.20, if the driver supports them: initialiser lists, and `return 1;` in a float
    // function.
    start += "#extension GL_ARB_shading_language_420pack : enable\n";
    if (!define.empty())
        start += fmt::format("#define {}\n", define);
    for (const OldName& name : old_names)
        if (words.contains(name.old) && !name.declaration.empty())
            start.append(name.declaration).push_back('\n');
    return start + host_declarations(text);
}
}  // namespace

Stage fragment_shader_stage(const Stage& written, std::string_view define) {
    GlslWords words;
    add_words(written.text, words);
    WordChanges changes{{"varying", "in"}};
    for (const OldName& name : old_names)
        changes.emplace(name.old, name.now);
    const std::string start = start_of(words, written.text, define);
    const std::string text = modern_glsl(written.text, changes, glsl_version_of(written.text));
    Stage stage;
    stage.file = written.file;
    stage.text = start + LayoutCleaner(text).clean();
    stage.lines.append({{}, 1}, static_cast<std::size_t>(std::ranges::count(start, '\n')));
    for (std::size_t line = 0; line < written.lines.size(); ++line)
        stage.lines.push_back(written.lines[line]);
    return stage;
}
