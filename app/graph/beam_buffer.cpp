#include "graph/beam_buffer.h"

#include <cstddef>

void BeamBuffer::advance(const Frame& frame) {
    m_before = frame.is_first ? std::nullopt : m_last;
    if (m_before)
        m_before->age_seconds += static_cast<float>(frame.time_delta);
    m_last = frame.beam.empty() ? m_before : std::optional(frame.beam.back());
}

void BeamBuffer::clear() {
    m_before.reset();
    m_last.reset();
}

void BeamBuffer::write(const Frame& frame, bool has_points, bool has_segments) {
    m_point_count = static_cast<int>(frame.beam.size());
    if (has_points)
        m_point_buffer.write(std::as_bytes(frame.beam));
    if (!has_segments)
        return;
    make_segments(frame.beam, m_before, m_segments);
    m_segment_buffer.write(std::as_bytes(std::span(m_segments)));
}

namespace {
struct Field {
    const char* name;
    int components;
    std::size_t offset;
};

constexpr Field point_fields[] = {{"position", 2, offsetof(BeamPoint, x)},
                                  {"intensity", 1, offsetof(BeamPoint, intensity)},
                                  {"age_seconds", 1, offsetof(BeamPoint, age_seconds)}};
constexpr Field segment_fields[] = {{"segment", 4, offsetof(Segment, x0)},
                                    {"intensities", 2, offsetof(Segment, start_intensity)},
                                    {"ages_seconds", 2, offsetof(Segment, start_age)}};

gpu::Attribute attribute_of(const gpu::Program& program, const Field& field, std::size_t stride,
                            bool is_per_instance) {
    return {program.attribute_location(field.name), field.components, static_cast<int>(stride),
            static_cast<int>(field.offset), is_per_instance};
}
}  // namespace

gpu::VertexArray BeamBuffer::vertices_for(const gpu::Program& program, Draw draw) const {
    gpu::VertexArray vertices;
    if (draw == Draw::points)
        for (const Field& field : point_fields)
            vertices.set(attribute_of(program, field, sizeof(BeamPoint), false), m_point_buffer);
    if (draw == Draw::segments)
        for (const Field& field : segment_fields)
            vertices.set(attribute_of(program, field, sizeof(Segment), true), m_segment_buffer);
    return vertices;
}
