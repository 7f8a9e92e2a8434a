#pragma once

#include "graph/beam/beam_buffer.h"
#include "graph/beam/quad.h"
#include "graph/executor/frame_graph.h"

/// The vertices that passes draw: a triangle or quad over the whole target, or the beam.
struct Shapes {
    Quad quad;
    BeamBuffer beam;

    /// The vertex attributes for a program that draws this shape.
    gpu::VertexArray vertices_for(const gpu::Program& program, Draw shape) const {
        return shape == Draw::quad ? quad.vertices() : beam.vertices_for(program, shape);
    }
};
