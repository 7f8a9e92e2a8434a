#pragma once

#include "gpu/objects/vertex_array.h"
#include "gpu/program.h"
#include "graph/beam/segment.h"
#include "graph/programs/frame.h"

#include <array>

/// A frame's beam as vertices: points, and the segments that join them across frames.
class BeamBuffer {
public:
    /// A new frame begins: its first point will join the last one of the frame before.
    void advance(const Frame& frame);
    /// Forgets the frames before.
    void clear();
    /// Makes the vertices that the draw modes in use need: points, and segments for the smallest
    /// spot that these are drawn with. Places are multiplied by `scale`.
    void write(const Frame& frame, bool has_points, const std::optional<BeamSpot>& segments,
               const std::array<double, 2>& scale = {1.0, 1.0});

    /// The attributes of a program of a `draw` pass.
    gpu::VertexArray vertices_for(const gpu::Program& program, Draw draw) const;
    /// Lets the vertices of such a pass take the frame's colours, or white where it has none.
    void choose_tints(const gpu::VertexArray& vertices, int location, Draw draw) const;
    int point_count() const { return m_point_count; }
    int segment_count() const { return static_cast<int>(m_segments.size()); }

private:
    gpu::StreamBuffer m_point_buffer;
    gpu::StreamBuffer m_segment_buffer;
    gpu::StreamBuffer m_point_tint_buffer;  // these two are empty while the beam has no colours
    gpu::StreamBuffer m_segment_tint_buffer;
    std::vector<Segment> m_segments;
    SegmentTints m_tints;
    std::vector<BeamPoint> m_scaled;  // the frame's points where they are scaled
    bool m_has_tints = false;
    std::optional<BeamPoint>
        m_before;                     // the last point of the frames before, aged to this one's end
    std::optional<BeamPoint> m_last;  // of this frame
    int m_point_count = 0;
};
