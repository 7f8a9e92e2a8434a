#pragma once

#include "gpu/objects/vertex_array.h"
#include "gpu/program.h"
#include "graph/beam/segment.h"
#include "graph/programs/frame.h"

#include <array>

/// The beam of a frame as vertices: points, and segments that connect them across frames.
class BeamBuffer {
public:
    /// Starts a frame. Its first point is connected to the last point of the previous frame.
    void advance(const Frame& frame);
    /// Discards the previous frames.
    void clear();
    /// Uploads the vertices that the used draw modes need. `segments` is the smallest spot of the
    /// passes that draw segments; nullopt: only points. Positions are multiplied by `scale`.
    void write(const Frame& frame, bool has_points, const std::optional<BeamSpot>& segments,
               const std::array<double, 2>& scale = {1.0, 1.0});

    /// The vertex attributes for the program of a pass with this draw mode.
    gpu::VertexArray vertices_for(const gpu::Program& program, Draw draw) const;
    /// Selects the frame's colours for the attribute at `location`; white if the frame has none.
    void choose_tints(const gpu::VertexArray& vertices, int location, Draw draw) const;
    int point_count() const { return m_point_count; }
    int segment_count() const { return static_cast<int>(m_segments.size()); }

private:
    gpu::StreamBuffer m_point_buffer;
    gpu::StreamBuffer m_segment_buffer;
    gpu::StreamBuffer m_point_tint_buffer;  // both: empty while the beam has no colours
    gpu::StreamBuffer m_segment_tint_buffer;
    std::vector<Segment> m_segments;
    SegmentTints m_tints;
    std::vector<BeamPoint> m_scaled;  // the frame's points, if scaled
    bool m_has_tints = false;
    std::optional<BeamPoint> m_before;  // last point of previous frames, aged to this one's end
    std::optional<BeamPoint> m_last;    // of this frame
    int m_point_count = 0;
};
