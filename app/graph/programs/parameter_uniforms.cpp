#include "graph/programs/parameter_uniforms.h"

#include <algorithm>

namespace {
const gpu::Program* program_of(const Programs& programs, int pass) {
    if (pass < 0 || static_cast<std::size_t>(pass) >= programs.passes.size())
        return nullptr;
    return programs.passes[static_cast<std::size_t>(pass)].program.get();
}
}  // namespace

ParameterUniforms::ParameterUniforms(const Look& look, const Programs& programs) {
    for (std::size_t i = 0; i < look.passes.size(); ++i)
        for (const auto& [uniform, value] : look.passes[i].set)
            programs.passes[i].program->write(uniform, value.numbers);

    for (std::size_t i = 0; i < programs.passes.size(); ++i)
        find_orbits(look, static_cast<int>(i), *programs.passes[i].program);
    for (std::size_t i = 0; i < look.parameters.size(); ++i) {
        if (look.parameters[i].orbit != OrbitPart::none)
            continue;
        Driven driven{i, {}, {}, look.parameters[i].control == Control::event};
        for (const Binding& binding : look.parameters[i].bindings) {
            const gpu::Program* program = program_of(programs, binding.pass);
            const gpu::Uniform* uniform =
                program ? program->find_uniform(binding.uniform) : nullptr;
            if (uniform && uniform->number)
                driven.targets.push_back({program, uniform});
        }
        if (!driven.targets.empty())
            m_driven.push_back(std::move(driven));
    }
}

void ParameterUniforms::find_orbits(const Look& look, int pass, const gpu::Program& program) {
    for (const BuiltInUniform& built_in : look.passes[static_cast<std::size_t>(pass)].built_ins) {
        if (built_in.kind != BuiltIn::view && built_in.kind != BuiltIn::camera)
            continue;
        if (const gpu::Uniform* uniform = program.find_uniform(built_in.name))
            m_orbit_uniforms.push_back(
                {pass,
                 {&program, uniform},
                 built_in.kind == BuiltIn::view ? view_matrix : camera_matrix,
                 {}});
    }
}

void ParameterUniforms::write_to(const Driven& driven, const Value& usable) {
    for (const UniformTarget& target : driven.targets)
        target.program->write(*target.uniform, usable.numbers);
}

void ParameterUniforms::end_events() {
    for (Driven& driven : m_driven) {
        if (!driven.is_event || driven.written.number() == 0.0)
            continue;
        driven.is_over = true;
        driven.written = Value(0.0);
        write_to(driven, driven.written);
    }
}

void ParameterUniforms::forget_written() {
    for (OrbitUniform& orbit_uniform : m_orbit_uniforms)
        orbit_uniform.written.reset();
    for (Driven& driven : m_driven)
        driven.written = {};
}

void ParameterUniforms::write_orbits(const Look& look, const Values& values) {
    for (OrbitUniform& orbit_uniform : m_orbit_uniforms) {
        const Orbit orbit = orbit_of(look, values, orbit_uniform.pass);
        if (orbit_uniform.written != orbit)
            orbit_uniform.target.program->write(*orbit_uniform.target.uniform,
                                                orbit_uniform.matrix(orbit));
        orbit_uniform.written = orbit;
    }
}

void ParameterUniforms::write(Driven& driven, const Parameter& parameter, const Values& values) {
    Value value = value_of(parameter, values);
    driven.is_over = driven.is_over && value.number() != 0.0;
    if (driven.is_over)
        value = Value(0.0);
    if (value == driven.written && !driven.written.numbers.empty())
        return;
    write_to(driven, value_for_shaders(parameter, value));
    driven.written = value;
}

void ParameterUniforms::write(const Look& look, const Values& values) {
    write_orbits(look, values);
    for (Driven& driven : m_driven)
        write(driven, look.parameters[driven.parameter], values);
}

void ParameterUniforms::write(const Look& look, const Values& values,
                              const std::vector<std::string>& changed) {
    write_orbits(look, values);
    for (Driven& driven : m_driven) {
        const Parameter& parameter = look.parameters[driven.parameter];
        if (driven.written.numbers.empty() || std::ranges::binary_search(changed, parameter.name))
            write(driven, parameter, values);
    }
}
