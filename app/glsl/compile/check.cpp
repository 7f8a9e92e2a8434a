#include "glsl/compile/check.h"

#include "glsl/compile/compiler_log.h"
#include "glsl/compile/interface.h"
#include "glsl/compile/live.h"
#include "glsl/compile/plain_messages.h"
#include "glsl/compile/tree.h"
#include "glsl/compile/version_line.h"
#include "glsl/limits/bounds.h"
#include "glsl/limits/large_declarations.h"
#include "glsl/limits/stage_cost.h"
#include "glsl/limits/start.h"
#include "glsl/limits/unbounded_loops.h"
#include "glsl/text/include.h"
#include "glsl/text/tokens.h"
#include "glsl/text/uniform_lines.h"

#include <fmt/format.h>
#include <glslang/Public/ResourceLimits.h>
#include <glslang/Public/ShaderLang.h>

#include <algorithm>

namespace {
constexpr int glsl_version = 410;
constexpr EShMessages parse_messages = EShMsgDefault;

// Errors in built-in lines are reported for the author's file as a whole.
Location author_location(const Stage& stage, int line) {
    const Location at = location_in(stage, line);
    return at.file.empty() ? Location{stage.file, 0} : at;
}

Diagnostic diagnostic_from(const CompilerMessage& message, const Stage& stage,
                           const std::string& text) {
    // Link messages have no line; use the first line with the name in the message.
    const int line = message.line > 0 ? message.line : first_line_of(message.subject, text);
    const Location at = author_location(stage, line);
    return {at.file, at.line, message.text,
            message.is_warning ? Severity::warning : Severity::error};
}

/// A stage and its glslang shader.
class Compiled {
public:
    Compiled(const Stage& stage, EShLanguage language)
        : m_stage(stage),
          m_text(with_nested_arrays(without_line_directives(stage.text))),
          m_shader(language) {
        m_pieces[0] = m_text.c_str();
        m_sizes[0] = static_cast<int>(m_text.size());
        m_shader.setStringsWithLengths(m_pieces, m_sizes, 1);
    }

    void parse(Diagnostics& problems) {
        // Before the parse: find_uniform_lines() may run glslang's preprocessor, which takes over
        // the thread's memory pool.
        for (const auto& [name, line] : find_uniform_lines(m_text, m_shader.getStage()))
            m_places.emplace(name, location_in(m_stage, line));
        const bool is_good = m_shader.parse(GetDefaultResources(), glsl_version, ECoreProfile,
                                            false, false, parse_messages);
        Diagnostics found;
        std::vector<CompilerMessage> messages = parse_compiler_log(m_shader.getInfoLog());
        explain(messages, m_text, {.stage = m_shader.getStage(), .version = glsl_version});
        for (const CompilerMessage& message : messages)
            found.push_back(diagnostic_from(message, m_stage, m_text));
        if (!is_good && !has_errors(found)) {
            const Location at = location_in(m_stage, 1);
            found.push_back({at.file, at.line, refused_without_reason});
        }
        problems.insert(problems.end(), found.begin(), found.end());
    }

    StageInterface interface(Diagnostics& problems) {
        return read_tree(m_shader, m_places, problems);
    }

    glslang::TShader& shader() { return m_shader; }
    const Stage& stage() const { return m_stage; }
    const std::string& text() const { return m_text; }

private:
    const Stage& m_stage;
    std::string m_text;
    const char* m_pieces[1];
    int m_sizes[1];
    std::map<std::string, Location> m_places;
    glslang::TShader m_shader;
};

void link(Compiled& vertex, Compiled& fragment, Diagnostics& problems) {
    glslang::TProgram program;
    program.addShader(&vertex.shader());
    program.addShader(&fragment.shader());
    if (program.link(parse_messages))
        return;
    for (const CompilerMessage& message : parse_compiler_log(program.getInfoLog())) {
        const Compiled& about = message.is_about_vertex_stage ? vertex : fragment;
        problems.push_back(diagnostic_from(message, about.stage(), about.text()));
    }
}

std::vector<std::string> live_in(Compiled& vertex, Compiled& fragment) {
    std::vector<std::string> live = live_uniforms(vertex.shader());
    for (std::string& name : live_uniforms(fragment.shader()))
        if (std::ranges::find(live, name) == live.end())
            live.push_back(std::move(name));
    return live;
}

void check_varying_counts(const StageInterface& declared, const Stage& stage,
                          Diagnostics& problems) {
    constexpr std::size_t max_varyings = 256;
    const std::size_t count = std::max(declared.inputs.size(), declared.outputs.size());
    if (count > max_varyings)
        problems.push_back(
            {stage.file, 0,
             fmt::format("the shader has {} varyings; the limit is {}", count, max_varyings)});
}

// Checks that must pass before glslang parses a text.
void check_text(const Stage& stage, const ShaderLimits& limits, Diagnostics& problems) {
    const Diagnostics version = check_version(stage);
    problems.insert(problems.end(), version.begin(), version.end());
    check_bounds(stage, limits, problems);
}
}  // namespace

void check_bounds(const Stage& stage, const ShaderLimits& limits, Diagnostics& problems) {
    auto fault = find_limit_violation(stage.text);
    if (!fault)
        fault = find_large_declaration(stage.text, limits);
    if (!fault)
        return;
    const Location at = author_location(stage, fault->line);
    problems.push_back({at.file, at.line, fault->message});
}

void check_cost(glslang::TShader& shader, const Stage& stage, const ShaderLimits& limits,
                Diagnostics& problems) {
    for (const int line : unbounded_loops(shader)) {
        const Location at = author_location(stage, line);
        add_new(problems, {{at.file, at.line, unbounded_loop, Severity::warning}});
    }
    const auto exceeded = find_exceeded(estimate_cost(shader), limits);
    if (!exceeded)
        return;
    const Location at = author_location(stage, exceeded->figure.line);
    problems.push_back({at.file, at.line, refusal(*exceeded, limits)});
}

std::string with_indefinite_article(const std::string& type_name) {
    const bool is_vowel = type_name.starts_with('i') || type_name.starts_with('a');
    return (is_vowel ? "an " : "a ") + type_name;
}

Location location_in(const Stage& stage, int line) {
    return stage.lines.empty() ? Location{stage.file, line} : origin_of(stage.lines, line);
}

Result<Reflection> check_program(const Stage& vertex, const Stage& fragment,
                                 const ShaderLimits& limits) {
    Diagnostics problems;
    check_text(vertex, limits, problems);
    check_text(fragment, limits, problems);
    if (!problems.empty())
        return fail(std::move(problems));

    start_glslang();
    Compiled compiled_vertex(vertex, EShLangVertex);
    Compiled compiled_fragment(fragment, EShLangFragment);
    compiled_vertex.parse(problems);
    compiled_fragment.parse(problems);
    if (has_errors(problems))
        return fail(std::move(problems));
    check_cost(compiled_vertex.shader(), vertex, limits, problems);
    check_cost(compiled_fragment.shader(), fragment, limits, problems);
    if (has_errors(problems))
        return fail(std::move(problems));

    Reflection reflection;
    const StageInterface from = compiled_vertex.interface(problems);
    const StageInterface to = compiled_fragment.interface(problems);
    check_varying_counts(from, vertex, problems);
    check_varying_counts(to, fragment, problems);
    if (has_errors(problems))
        return fail(std::move(problems));
    reflection.uniforms = merged_uniforms(from, to, problems);
    check_varyings(from, to, fragment, problems);
    reflection.live = live_in(compiled_vertex, compiled_fragment);  // before linking, which takes
                                                                    // over their memory
    if (!has_errors(problems))
        link(compiled_vertex, compiled_fragment, problems);
    if (has_errors(problems))
        return fail(std::move(problems));
    reflection.warnings = std::move(problems);
    return reflection;
}

void warm_up() {
    const Stage fragment = builtin_stage("#version 410 core\nvoid main() {}\n");
    static_cast<void>(check_program(fullscreen_vertex_stage(), fragment));
}
