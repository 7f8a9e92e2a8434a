#include "graph/programs/sample_programs.h"

std::string_view glsl_prefix(SampleKind kind) {
    constexpr std::array<std::string_view, 3> prefixes{"", "u", "i"};
    return prefixes[static_cast<std::size_t>(kind)];
}

Result<SamplePrograms> SamplePrograms::make(Build build) {
    SamplePrograms programs(std::move(build));
    if (const auto& floats = programs.made(SampleKind::floating); !floats)
        return fail(floats.error());
    return programs;
}

const gpu::Program* SamplePrograms::find(Format read) const {
    const auto& program = made(sample_kind_of(read));
    return program ? &*program : nullptr;
}

const Result<gpu::Program>& SamplePrograms::made(SampleKind kind) const {
    auto& program = m_made[static_cast<std::size_t>(kind)];
    if (!program)
        program = m_build(kind);
    return *program;
}
