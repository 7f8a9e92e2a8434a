#include "formats/slang/shader.h"

#include "formats/slang/expand.h"
#include "formats/slang/words.h"

#include <fmt/format.h>

#include <array>

namespace fs = std::filesystem;

namespace {
// Shaders declare the uniforms of newer hosts only where the host says that it has them.
constexpr std::array<std::string_view, 4> host_definitions{
    "#define _HAS_ORIGINALASPECT_UNIFORMS\n",
    "#define _HAS_FRAMETIME_UNIFORMS\n",
    "#define _HAS_ROTATION_UNIFORM\n",
    "#define _HAS_SENSOR_UNIFORMS\n",
};

std::string_view first_word(std::string_view text) {
    return text.substr(0, std::min(text.find_first_of(" \t\r\n"), text.size()));
}

class ShaderReader {
public:
    explicit ShaderReader(const fs::path& file) {
        m_shader.vertex.file = file;
        m_shader.fragment.file = file;
    }

    Result<SlangShader> read(const std::vector<SlangPiece>& pieces) {
        const bool is_shader =
            !pieces.empty() && pieces[0].lines.starts_with("#version") && pieces[0].first_line == 1;
        if (!is_shader)
            return fail({m_shader.vertex.file, 1, "a shader's first line must be #version"});
        add_version(pieces[0]);
        for (std::size_t i = 1; i < pieces.size(); ++i)
            pieces[i].directive ? obey(*pieces[i].directive, pieces[i]) : add_lines(pieces[i]);
        auto parameters = unique_slang_parameters(m_declared, m_shader.warnings);
        if (!parameters)
            m_errors.push_back(parameters.error().front());
        if (!m_errors.empty())
            return fail(std::move(m_errors));
        m_shader.parameters = std::move(*parameters);
        return std::move(m_shader);
    }

private:
    void add(std::string_view lines, const Location& first, std::size_t count) {
        for (Stage* stage : {&m_shader.vertex, &m_shader.fragment}) {
            if (m_only && m_only != stage)
                continue;
            stage->text += lines;
            stage->lines.append(first, count);
        }
    }

    void add_lines(const SlangPiece& piece) {
        add(piece.lines, {piece.text->file, piece.first_line}, piece.line_count);
    }

    void add_version(const SlangPiece& piece) {
        const std::size_t end = piece.lines.find('\n') + 1;
        add(piece.lines.substr(0, end), {piece.text->file, 1}, 1);
        for (const std::string_view definition : host_definitions)
            add(definition, {piece.text->file, 1}, 1);
        add(piece.lines.substr(end), {piece.text->file, 2}, piece.line_count - 1);
    }

    void obey(const SlangDirective& directive, const SlangPiece& piece) {
        using Kind = SlangDirective::Kind;
        const Location at{piece.text->file, directive.line};
        if (directive.kind == Kind::stage)
            open_stage(first_word(directive.argument), at);
        else if (directive.kind == Kind::name)
            set_once(m_shader.alias, m_shader.alias_declared, directive.argument, at, "name");
        else if (directive.kind == Kind::format)
            set_once(m_shader.format, m_shader.format_declared, directive.argument, at, "format");
        else if (directive.kind == Kind::parameter)
            add_parameter(directive.argument, at);
        add("\n", at, 1);
    }

    void open_stage(std::string_view word, const Location& at) {
        if (word == "vertex")
            m_only = &m_shader.vertex;
        else if (word == "fragment")
            m_only = &m_shader.fragment;
        else
            m_errors.push_back(
                {at.file, at.line,
                 fmt::format("unknown stage '{}': #pragma stage vertex or #pragma stage fragment",
                             readable_text(word))});
    }

    void set_once(std::string& value, Location& declared, std::string_view argument,
                  const Location& at, std::string_view pragma) {
        const std::string word = readable_text(first_word(argument));
        if (value.empty()) {
            value = word;
            declared = at;
        } else if (value != word) {
            m_shader.warnings.push_back(
                {at.file, at.line,
                 fmt::format("a second #pragma {} '{}': '{}' of line {} counts", pragma, word,
                             value, declared.line),
                 Severity::warning});
        }
    }

    void add_parameter(std::string_view argument, const Location& at) {
        auto parameter = parse_slang_parameter(argument, at);
        if (parameter)
            m_declared.push_back(std::move(*parameter));
        else
            m_errors.push_back(parameter.error().front());
    }

    SlangShader m_shader;
    Stage* m_only = nullptr;  // the open stage; none: both
    std::vector<SlangParameter> m_declared;
    Diagnostics m_errors;
};
}  // namespace

Result<SlangShader> read_slang_shader(const fs::path& file, SlangFiles& files) {
    const auto pieces = expand_slang(file, files);
    if (!pieces)
        return fail(pieces.error());
    return ShaderReader(file).read(*pieces);
}
