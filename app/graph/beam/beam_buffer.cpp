#include "graph/beam/beam_buffer.h"

#include "graph/beam/merge_segments.h"

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

namespace {
BeamPoint scaled(BeamPoint point, const std::array<double, 2>& scale) {
    point.x = static_cast<float>(point.x * scale[0]);
    point.y = static_cast<float>(point.y * scale[1]);
    return point;
}
}  // namespace

void BeamBuffer::write(const Frame& frame, bool has_points, const std::optional<BeamSpot>& segments,
                       const std::array<double, 2>& scale) {
    std::span<const BeamPoint> beam = frame.beam;
    std::optional<BeamPoint> before = m_before;
    if (scale != std::array{1.0, 1.0}) {
        m_scaled.clear();
        for (const BeamPoint& point : frame.beam)
            m_scaled.push_back(scaled(point, scale));
        beam = m_scaled;
        before = m_before ? std::optional(scaled(*m_before, scale)) : std::nullopt;
    }
    m_point_count = static_cast<int>(frame.beam.size());
    m_has_tints = !frame.tints.empty() && frame.tints.size() == frame.beam.size();
    m_tints.of_points = m_has_tints ? frame.tints : std::span<const BeamTint>();
    if (has_points) {
        m_point_buffer.write(std::as_bytes(beam));
        if (m_has_tints)
            m_point_tint_buffer.write(std::as_bytes(frame.tints));
    }
    if (!segments)
        return;
    make_segments(beam, before, m_segments, m_tints);
    merge_segments(m_segments, m_tints, *segments);
    m_segment_buffer.write(std::as_bytes(std::span(m_segments)));
    if (m_has_tints)
        m_segment_tint_buffer.write(std::as_bytes(std::span(m_tints.of_segments)));
}

void BeamBuffer::choose_tints(const gpu::VertexArray& vertices, int location, Draw draw) const {
    const bool is_any = draw == Draw::points ? m_point_count > 0 : !m_segments.empty();
    vertices.choose(location, m_has_tints && is_any);
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
    if (is_of_beam(draw))
        vertices.set(
            attribute_of(program, {"tint", 3, 0}, sizeof(BeamTint), draw == Draw::segments),
            draw == Draw::points ? m_point_tint_buffer : m_segment_tint_buffer);
    if (draw == Draw::points)
        for (const Field& field : point_fields)
            vertices.set(attribute_of(program, field, sizeof(BeamPoint), false), m_point_buffer);
    if (draw == Draw::segments)
        for (const Field& field : segment_fields)
            vertices.set(attribute_of(program, field, sizeof(Segment), true), m_segment_buffer);
    return vertices;
}
