#pragma once

#include "gpu/objects/canvas.h"
#include "gpu/objects/vertex_array.h"
#include "graph/compare/pair.h"

/// Draws what the other of two pictures adds to ours and takes from it, channel by channel and as a
/// display shows them, about a middle grey.
class SignedDifference {
public:
    static Result<SignedDifference> make();

    /// Differences of 1 / (2 * gain) reach white and black. Into a canvas of floats or bytes of the
    /// pictures' size, to be shown as it is.
    void draw(const Pair& pair, double gain, const gpu::Canvas& to);

private:
    explicit SignedDifference(gpu::Program program) : m_program(std::move(program)) {}

    gpu::Program m_program;
    gpu::VertexArray m_vertices;
    gpu::Samplers m_samplers;
};

/// The gain that shows a largest difference well: a power of two, 1 to 256 (half of a level of 255
/// is then a quarter of the way to white).
double gain_for(double largest);
