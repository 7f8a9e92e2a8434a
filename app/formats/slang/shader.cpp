#include "formats/slang/shader.h"

#include "formats/slang/expand.h"
#include "formats/slang/slang_text.h"

#include <fmt/format.h>

#include <array>

namespace fs = std::filesystem;

namespace {
constexpr std::size_t max_parameters = 16384;

// Shaders declare uniforms of newer hosts only with these definitions.
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
            return fail({m_shader.vertex.file, 1, "the shader's first line must be #version"});
        add_version(pieces[0]);
        for (std::size_t i = 1; i < pieces.size(); ++i)
            pieces[i].directive ? obey(pieces[i]) : add(pieces[i]);
        append_locations();
        if (!m_errors.empty())
            return fail(std::move(m_errors));
        m_shader.parameters = unique_slang_parameters(m_declared, m_shader.warnings);
        if (m_shader.parameters.size() > max_parameters) {
            const Location& at = m_shader.parameters[max_parameters]->declared;
            return fail({at.file, at.line,
                         fmt::format("the shader has {} parameters; the limit is {}",
                                     m_shader.parameters.size(), max_parameters)});
        }
        return std::move(m_shader);
    }

private:
    void add(const SlangPiece& piece) {
        for (Stage* stage : {&m_shader.vertex, &m_shader.fragment})
            if (!m_only || m_only == stage)
                stage->text.own() += piece.lines;
        const bool follows =
            m_piece.text == piece.text &&
            m_piece.first_line + static_cast<int>(m_piece.line_count) == piece.first_line;
        if (follows) {
            m_piece.line_count += piece.line_count;
            return;
        }
        append_locations();
        m_piece = piece;
    }

    // Records the source locations of the last consecutive lines.
    void append_locations() {
        if (m_piece.text)
            for (Stage* stage : {&m_shader.vertex, &m_shader.fragment})
                if (!m_only || m_only == stage)
                    stage->lines.append({m_piece.text->file, m_piece.first_line},
                                        m_piece.line_count);
        m_piece = {};
    }

    void add_version(const SlangPiece& piece) {
        const std::size_t end = piece.lines.find('\n') + 1;
        add({piece.text, 1, 1, piece.lines.substr(0, end)});
        for (const std::string_view definition : host_definitions)
            add({piece.text, 1, 1, definition});
        add({piece.text, 2, piece.line_count - 1, piece.lines.substr(end)});
    }

    void obey(const SlangPiece& piece) {
        using Kind = SlangDirective::Kind;
        const SlangDirective& directive = *piece.directive;
        if (directive.kind == Kind::stage)
            open_stage(first_word(directive.argument), piece);
        else if (directive.kind == Kind::name)
            set_once(m_shader.alias, m_shader.alias_declared, piece, "name");
        else if (directive.kind == Kind::format)
            set_once(m_shader.format, m_shader.format_declared, piece, "format");
        else if (directive.kind == Kind::parameter)
            add_parameter(piece);
        add({piece.text, piece.first_line, 1, "\n"});
    }

    static Location location_of(const SlangPiece& piece) {
        return {piece.text->file, piece.first_line};
    }

    void open_stage(std::string_view word, const SlangPiece& piece) {
        append_locations();
        if (word == "vertex")
            m_only = &m_shader.vertex;
        else if (word == "fragment")
            m_only = &m_shader.fragment;
        else
            add_new(m_errors,
                    {piece.text->file, piece.first_line,
                     fmt::format(
                         "unknown stage '{}'; use #pragma stage vertex or #pragma stage fragment",
                         readable_text(word))});
    }

    void set_once(std::string& value, Location& declared, const SlangPiece& piece,
                  std::string_view pragma) {
        const std::string word = readable_text(first_word(piece.directive->argument));
        if (value.empty()) {
            value = word;
            declared = location_of(piece);
        } else if (value != word) {
            add_new(
                m_shader.warnings,
                {piece.text->file, piece.first_line,
                 fmt::format("#pragma {0} '{1}' is ignored because line {3} has #pragma {0} '{2}'",
                             pragma, word, value, declared.line),
                 Severity::warning});
        }
    }

    void add_parameter(const SlangPiece& piece) {
        const auto index =
            static_cast<std::size_t>(piece.directive - piece.text->directives.data());
        if (const auto& parameter = piece.text->parameters[index])
            m_declared.push_back(parameter);
        else
            add_new(m_errors,
                    parse_slang_parameter(piece.directive->argument, location_of(piece)).error());
    }

    SlangShader m_shader;
    Stage* m_only = nullptr;  // the open stage; null: both
    SlangPiece m_piece;       // lines whose locations are not recorded yet
    SlangParameters m_declared;
    Diagnostics m_errors;
};
}  // namespace

Result<SlangShader> read_slang_shader(const fs::path& file, SlangFiles& files) {
    const auto pieces = expand_slang(file, files);
    if (!pieces)
        return fail(pieces.error());
    return ShaderReader(file).read(*pieces);
}
