#include "graph/built_in_uniforms.h"

#include <array>

BuiltInUniforms::BuiltInUniforms(const gpu::Program& program)
    : m_time(program.find_uniform("u_time")),
      m_time_delta(program.find_uniform("u_time_delta")),
      m_frame(program.find_uniform("u_frame")),
      m_resolution(program.find_uniform("u_resolution")),
      m_output_resolution(program.find_uniform("u_output_resolution")),
      m_source_resolution(program.find_uniform("u_source_resolution")),
      m_mouse(program.find_uniform("u_mouse")),
      m_samples(program.find_uniform("u_samples")) {}

namespace {
template <std::size_t Count>
void write_if(const gpu::Program& program, const gpu::Uniform* uniform,
              const std::array<double, Count>& numbers) {
    if (uniform)
        program.write(*uniform, numbers);
}

std::array<double, 2> numbers_of(Extent extent) {
    return {static_cast<double>(extent.width), static_cast<double>(extent.height)};
}
}  // namespace

void BuiltInUniforms::write(const gpu::Program& program, const Frame& frame, double number,
                            const PassExtents& extents) const {
    write_if<1>(program, m_time, {frame.time});
    write_if<1>(program, m_time_delta, {frame.time_delta});
    write_if<1>(program, m_frame, {number});
    write_if(program, m_resolution, numbers_of(extents.target));
    write_if(program, m_output_resolution, numbers_of(extents.output));
    write_if(program, m_source_resolution, numbers_of(extents.source));
    write_if(program, m_mouse, frame.mouse);
}

void BuiltInUniforms::write_samples(const gpu::Program& program, int samples) const {
    write_if<1>(program, m_samples, {static_cast<double>(samples)});
}
