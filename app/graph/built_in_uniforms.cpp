#include "graph/built_in_uniforms.h"

#include <span>

BuiltInUniforms::BuiltInUniforms(const gpu::Program& program)
    : m_time(program.find_uniform("u_time")),
      m_time_delta(program.find_uniform("u_time_delta")),
      m_frame(program.find_uniform("u_frame")),
      m_resolution(program.find_uniform("u_resolution")),
      m_output_resolution(program.find_uniform("u_output_resolution")),
      m_source_resolution(program.find_uniform("u_source_resolution")),
      m_mouse(program.find_uniform("u_mouse")),
      m_samples(program.find_uniform("u_samples")) {}

std::array<BuiltInUniforms::Told, 7> BuiltInUniforms::tell(const Frame& frame, double number,
                                                           const PassExtents& extents) const {
    const auto side = [](int pixels) { return static_cast<double>(pixels); };
    const auto size = [&](const gpu::Uniform* uniform, Extent extent) {
        return Told{uniform, {side(extent.width), side(extent.height)}, 2};
    };
    return {Told{m_time, {frame.time, 0.0}, 1},
            Told{m_time_delta, {frame.time_delta, 0.0}, 1},
            Told{m_frame, {number, 0.0}, 1},
            size(m_resolution, extents.target),
            size(m_output_resolution, extents.output),
            size(m_source_resolution, extents.source),
            Told{m_mouse, frame.mouse, 2}};
}

void BuiltInUniforms::write(const gpu::Program& program, const Frame& frame, double number,
                            const PassExtents& extents) const {
    for (const Told& told : tell(frame, number, extents))
        if (told.uniform)
            program.write(*told.uniform, std::span(told.numbers).first(told.count));
}

void BuiltInUniforms::write_samples(const gpu::Program& program, int samples) const {
    if (m_samples)
        program.write(*m_samples, std::array{static_cast<double>(samples)});
}

std::vector<BuiltInReport> BuiltInUniforms::report(const Frame& frame, double number,
                                                   const PassExtents& extents, int samples) const {
    std::vector<BuiltInReport> all;
    for (const Told& told : tell(frame, number, extents))
        if (told.uniform)
            all.push_back({told.uniform->name,
                           {told.numbers.begin(),
                            told.numbers.begin() + static_cast<std::ptrdiff_t>(told.count)}});
    if (m_samples)
        all.push_back({m_samples->name, {static_cast<double>(samples)}});
    return all;
}
