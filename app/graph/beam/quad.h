#pragma once

#include "gpu/objects/vertex_array.h"

/// The four corners of a Draw::quad pass, from (0, 0) to (1, 1), as a strip.
class Quad {
public:
    Quad();

    /// Corners at locations 0 and 1.
    gpu::VertexArray vertices() const;

private:
    gpu::StreamBuffer m_corners;
};
