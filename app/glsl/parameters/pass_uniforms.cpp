#include "glsl/parameters/pass_uniforms.h"

#include "glsl/parameters/builtins.h"
#include "glsl/text/include.h"

#include <fmt/format.h>

#include <algorithm>

namespace {
const Stage& vertex_of(const Pass& pass) {
    return pass.vertex.text->empty() ? fullscreen_vertex_stage() : pass.vertex;
}

class Sorter {
public:
    Sorter(const Pass& pass, int index) : m_pass(pass), m_index(index) {}

    PassUniforms sort(const Reflection& reflection, CheckCache* cache) {
        m_result.warnings = reflection.warnings;
        for (const Uniform& uniform : reflection.uniforms)
            m_names.push_back(uniform.name);
        for (const auto& [name, value] : m_pass.set)
            check_set(name, value, reflection);
        for (const auto& [name, parameter] : m_pass.rename)
            check_rename(name, reflection);
        for (const Input& input : m_pass.inputs)
            check_input(input, reflection);
        for (const Uniform& uniform : reflection.uniforms)
            add(uniform);
        read_hints(cache);
        return std::move(m_result);
    }

private:
    void error(const Location& at, std::string message) {
        m_result.errors.push_back({at.file, at.line, std::move(message)});
    }

    // The uniform named by a key of the pass in look.json; null with an error if unusable.
    const Uniform* find(const std::string& key, const std::string& name,
                        const Reflection& reflection) {
        const auto found = std::ranges::find(reflection.uniforms, name, &Uniform::name);
        if (found != reflection.uniforms.end() && !is_set_by_program(name))
            return &*found;
        if (found != reflection.uniforms.end())
            error(m_pass.declared,
                  fmt::format("pass '{}': '{}' names '{}', which Afterglow sets automatically",
                              m_pass.name, key, name));
        else
            error(m_pass.declared,
                  fmt::format("pass '{}': '{}' names '{}', which no shader of the pass declares{}",
                              m_pass.name, key, name, did_you_mean(name, m_names)));
        return nullptr;
    }

    void check_set(const std::string& name, const Value& value, const Reflection& reflection) {
        const Uniform* const uniform = find("set", name, reflection);
        if (!uniform)
            return;
        if (uniform->kind != Uniform::Kind::number)
            error(m_pass.declared,
                  fmt::format("pass '{}': 'set' can't set '{}', which is {}", m_pass.name, name,
                              with_indefinite_article(uniform->type_name)));
        else if (value.numbers.size() != static_cast<std::size_t>(uniform->type.size()))
            error(m_pass.declared,
                  fmt::format(
                      "pass '{}': wrong number of values for '{}' in 'set'; {} needs {}, got {}",
                      m_pass.name, name, with_indefinite_article(uniform->type_name),
                      uniform->type.size(), value.numbers.size()));
    }

    void check_rename(const std::string& name, const Reflection& reflection) {
        if (find("rename", name, reflection) && m_pass.set.contains(name))
            error(m_pass.declared,
                  fmt::format("pass '{}': '{}' can't be in both 'set' and 'rename'", m_pass.name,
                              name));
    }

    void check_input(const Input& input, const Reflection& reflection) {
        const Uniform* const uniform = find("inputs", input.uniform, reflection);
        if (uniform && uniform->kind != Uniform::Kind::sampler)
            error(m_pass.declared,
                  fmt::format("pass '{}': input '{}' must be a sampler, got {}", m_pass.name,
                              input.uniform, with_indefinite_article(uniform->type_name)));
    }

    void add(const Uniform& uniform) {
        if (is_set_by_program(uniform.name))
            return check_builtin(uniform);
        if (m_pass.set.contains(uniform.name))
            return;
        if (uniform.kind == Uniform::Kind::other) {
            const Location& at = uniform.declared.front();
            m_result.warnings.push_back(
                {at.file, at.line, uniform.why_no_control, Severity::warning});
            return;
        }
        if (uniform.kind == Uniform::Kind::sampler && has_input(uniform.name))
            return;
        if (uniform.kind == Uniform::Kind::sampler && uniform.type_name != "sampler2D")
            return error(
                uniform.declared.front(),
                fmt::format("'{}' has no input in pass '{}'; only a sampler2D can be a picture "
                            "parameter",
                            uniform.name, m_pass.name));
        const auto renamed = m_pass.rename.find(uniform.name);
        const std::string& parameter =
            renamed == m_pass.rename.end() ? uniform.name : renamed->second;
        m_result.free.push_back({parameter, uniform, {}, {m_index, uniform.name}});
    }

    bool has_input(const std::string& name) const {
        return std::ranges::find(m_pass.inputs, name, &Input::uniform) != m_pass.inputs.end();
    }

    // Whether the program sets the uniform: Afterglow's built-ins, or those of another host.
    bool is_set_by_program(const std::string& name) const {
        return std::ranges::find(m_pass.built_ins, name, &BuiltInUniform::name) !=
               m_pass.built_ins.end();
    }

    void check_builtin(const Uniform& uniform) {
        m_result.built_in.push_back(uniform.name);
        const bool is_our_look = m_pass.built_ins == own_built_ins();  // other hosts' built-ins
                                                                       // accept any number type
        const BuiltInDeclaration* builtin =
            is_our_look ? find_builtin_uniform(uniform.name) : nullptr;
        const bool is_right =
            !builtin || (uniform.kind == Uniform::Kind::number && uniform.type == builtin->type);
        if (!is_right)
            error(uniform.declared.front(),
                  fmt::format("Afterglow sets '{}', so it must be {}, got {}", uniform.name,
                              with_indefinite_article(glsl_name(builtin->type)),
                              with_indefinite_article(uniform.type_name)));
    }

    void read_hints(CheckCache* cache) {
        if (m_result.free.empty())
            return;
        for (const Stage* stage : {&vertex_of(m_pass), &m_pass.fragment}) {
            const auto notes = notes_of(*stage, cache);
            for (const UniformNotes& uniform : notes->uniforms)
                read_hints(uniform);
        }
    }

    void read_hints(const UniformNotes& notes) {
        const auto free = std::ranges::find_if(m_result.free, [&](const FreeUniform& other) {
            const auto& declared = other.uniform.declared;
            return other.uniform.name == notes.name &&
                   std::ranges::find(declared, notes.declared) != declared.end();
        });
        if (free == m_result.free.end())
            return;
        m_result.errors.insert(m_result.errors.end(), notes.errors.begin(), notes.errors.end());
        merge_hints(free->hints, notes.hints, free->parameter, m_result.errors);
    }

    const Pass& m_pass;
    int m_index;
    std::vector<std::string> m_names;
    PassUniforms m_result;
};
}  // namespace

PassUniforms find_pass_uniforms(const Pass& pass, int index, CheckCache* cache) {
    PassUniforms failed;
    if (pass.vertex.text->empty() && pass.draw != Draw::fullscreen) {
        failed.errors = {
            {pass.declared.file, pass.declared.line,
             pass.draw == Draw::points
                 ? fmt::format("pass '{}' draws points and needs a vertex shader", pass.name)
                 : fmt::format("pass '{}' draws segments and needs a vertex shader", pass.name)}};
        return failed;
    }
    const Stage& vertex = vertex_of(pass);
    auto reflection =
        cache ? cache->check(vertex, pass.fragment) : check_program(vertex, pass.fragment);
    if (!reflection) {
        failed.errors = std::move(reflection.error());
        return failed;
    }
    return Sorter(pass, index).sort(*reflection, cache);
}
