#include "glsl/text/include.h"

#include "base/text.h"
#include "glsl/text/include_paths.h"
#include "glsl/text/shader_files.h"
#include "glsl/text/tokens.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace fs = std::filesystem;

namespace {
constexpr std::size_t max_nested_includes = 64;
constexpr int max_files = 4096;
constexpr std::size_t max_bytes = ShaderFiles::max_bytes;
constexpr std::size_t max_bytes_read = 4 * max_bytes;  // including files that add no lines
constexpr std::size_t max_errors = 32;
constexpr std::size_t max_lines = 200'000;

constexpr const char* too_large =
    "the shader with its includes is larger than the limit of 4 MiB or 200,000 lines";

class Assembler {
public:
    Assembler(const fs::path& file, const IncludeRoots& roots, std::vector<fs::path>& files,
              ShaderFiles& disk)
        : m_disk(disk), m_paths(file, roots, disk), m_given(roots.given), m_files(files) {
        m_stage.file = file;
        for (const fs::path& known : files)
            m_known.insert(known.native());
    }

    Result<Stage> assemble() {
        remember(m_stage.file);
        add_file(m_stage.file, {});
        if (!m_errors.empty())
            return fail(std::move(m_errors));
        return std::move(m_stage);
    }

private:
    void error(const Location& at, std::string message) {
        m_errors.push_back({at.file, at.line, std::move(message)});
        m_is_full = m_is_full || m_errors.size() >= max_errors;
    }

    void remember(const fs::path& file) {
        if (m_known.insert(file.native()).second)
            m_files.push_back(file);
    }

    void add_file(const fs::path& file, const Location& from) {
        const Result<ShaderText>& text = m_disk.read(file);
        if (!text)
            return refuse(file, from, text.error());
        m_bytes_read += text->file_size;
        if (text->file_size > max_bytes || m_bytes_read > max_bytes_read) {
            m_is_full = true;
            return error({file, 1}, too_large);
        }
        if (text->is_once)
            m_once.push_back(text->canonical);
        m_open.push_back({file, text->canonical});
        add_text(*text);
        m_open.pop_back();
    }

    // Errors about a whole file are reported at the #include.
    void refuse(const fs::path& file, const Location& from, const Diagnostics& reasons) {
        for (const Diagnostic& reason : reasons) {
            if (reason.line > 0 || from.line == 0)
                error({reason.file, reason.line}, reason.message);
            else
                error(from, fmt::format("can't read '{}': {}", file.string(), reason.message));
        }
    }

    void add_text(const ShaderText& from) {
        const fs::path file = m_open.back().path;
        const std::string_view text = from.text;
        if (from.unclosed_comment > 0)
            error({file, from.unclosed_comment}, "the comment that starts here has no closing */");
        std::size_t done = 0;
        int line = 1;
        for (const ShaderText::Include& directive : from.includes) {
            add_lines(text.substr(done, directive.begin - done), line, done > 0);
            include(directive, {file, directive.line});
            done = directive.end;
            line = directive.last_line;
        }
        add_lines(text.substr(done), line, done > 0);
    }

    // Adds a part of a file. The rests of a line around an #include are added only if they are not
    // blank: a comment may start or end there.
    void add_lines(std::string_view part, int first_line, bool starts_inside_line) {
        Location at{m_open.back().path, first_line};
        const auto lines = split(part, '\n');
        for (std::size_t i = 0; i < lines.size(); ++i, ++at.line) {
            const bool is_whole = (i > 0 || !starts_inside_line) && i + 1 < lines.size();
            if (is_whole || !trim(lines[i]).empty())
                add_line(lines[i], at);
        }
    }

    void add_line(std::string_view line, const Location& at) {
        if (m_is_full)
            return;
        if (m_stage.text->size() + line.size() >= max_bytes || m_stage.lines.size() >= max_lines) {
            m_is_full = true;
            return error(at, too_large);
        }
        m_stage.text.own().append(line).push_back('\n');
        m_stage.lines.push_back(at);
    }

    void add_given(std::string_view name, const Location& at) {
        if (std::ranges::find(m_given, name) == m_given.end())
            return error(at, fmt::format("unknown include <{}>; to include a file, use "
                                         "#include \"file.glsl\"",
                                         name));
        add_line(fmt::format("#include <{}>", name), at);
    }

    void include(const ShaderText::Include& directive, const Location& at) {
        if (m_is_full)
            return;
        if (!m_given.empty() && directive.given)
            return add_given(*directive.given, at);
        if (!directive.file)
            return error(at, "expected #include \"file.glsl\"");
        const std::string& name = *directive.file;
        if (std::string fault = fault_of_include_name(name); !fault.empty())
            return error(at, fault);
        const IncludePaths::Found found = m_paths.find(name, at.file.parent_path());
        for (const fs::path& path : found.tried)
            remember(path);
        if (!found.file)
            return error(at, why_not_found(name, found));
        const fs::path& real = m_disk.canonical_path(*found.file);
        if (!is_include_text(real))
            return error(at, fmt::format("'{}' is a link to '{}', which isn't a shader file", name,
                                         real.string()));
        enter(*found.file, at);
    }

    std::string why_not_found(const std::string& name, const IncludePaths::Found& found) const {
        if (found.escapes_root)
            return fmt::format(
                "'{}' is outside the open folder '{}'. Move the file into it, or add its folder "
                "with --include FOLDER (in the window: Edit > Includes).",
                name, m_paths.tree().string());
        return fmt::format(
            "can't find '{}' next to this file, in the look's folder or in an include folder{}",
            name, IncludePaths::nearest_name(found.tried));
    }

    void enter(const fs::path& file, const Location& at) {
        const fs::path& real = m_disk.canonical_path(file);
        if (std::ranges::find(m_once, real) != m_once.end())
            return;
        const auto open = std::ranges::find(m_open, real, &Open::real);
        if (open != m_open.end()) {
            std::string chain;
            for (auto link = open; link != m_open.end(); ++link)
                chain += link->path.filename().string() + " -> ";
            return error(at,
                         fmt::format("circular #include: {}{}", chain, file.filename().string()));
        }
        if (m_open.size() >= max_nested_includes)
            return error(at, fmt::format("includes are nested deeper than the limit of {} levels",
                                         max_nested_includes));
        if (++m_included > max_files) {
            m_is_full = true;
            return error(
                at, fmt::format("the shader has more includes than the limit of {}", max_files));
        }
        add_file(file, at);
    }

    struct Open {
        fs::path path;
        fs::path real;
    };

    ShaderFiles& m_disk;
    IncludePaths m_paths;
    std::span<const std::string_view> m_given;
    std::vector<fs::path>& m_files;
    Stage m_stage;
    Diagnostics m_errors;
    std::vector<Open> m_open;                 // from the top file to the current file
    std::vector<fs::path> m_once;             // files with #pragma once
    std::set<fs::path::string_type> m_known;  // the files in m_files
    std::size_t m_bytes_read = 0;
    int m_included = 0;
    bool m_is_full = false;
};
}  // namespace

Result<Stage> load_stage(const fs::path& file, const IncludeRoots& roots,
                         std::vector<fs::path>& files, ShaderFiles* disk) {
    ShaderFiles own;
    return Assembler(file, roots, files, disk ? *disk : own).assemble();
}

Stage with_line_after_version(const Stage& stage, std::string_view added) {
    Stage result{stage.file, {}, {}};
    bool is_added = false;
    const auto lines = split(*stage.text, '\n');
    for (std::size_t i = 0; i < stage.lines.size(); ++i) {
        result.text.own().append(lines[i]).push_back('\n');
        result.lines.push_back(stage.lines[i]);
        if (is_added || !trim(lines[i]).starts_with("#version"))
            continue;
        result.text.own().append(added).push_back('\n');
        result.lines.push_back(stage.lines[i]);
        is_added = true;
    }
    return result;
}

Stage builtin_stage(std::string text) {
    Stage stage;
    stage.lines.append({{}, 1}, split_lines(text).size());
    stage.text = without_line_directives(std::move(text));
    return stage;
}

const Stage& fullscreen_vertex_stage() {
    static const Stage stage = builtin_stage(
        "#version 410 core\n"
        "out vec2 uv;\n"
        "void main() {\n"
        "    uv = vec2((gl_VertexID << 1) & 2, gl_VertexID & 2);\n"
        "    gl_Position = vec4(uv * 2.0 - 1.0, 0.0, 1.0);\n"
        "}\n");
    return stage;
}
