#pragma once

#include "gpu/objects/canvas.h"
#include "gpu/objects/vertex_array.h"
#include "graph/compare/pair.h"

/// Draws `other` minus `ours`, per channel and as displayed, on middle grey.
class SignedDifference {
public:
    static Result<SignedDifference> make();

    /// Differences of 1 / (2 * gain) reach white and black. Into a float or byte canvas of the
    /// pictures' size, to be displayed without conversion.
    void draw(const Pair& pair, double gain, const gpu::Canvas& to);

private:
    explicit SignedDifference(gpu::Program program) : m_program(std::move(program)) {}

    gpu::Program m_program;
    gpu::VertexArray m_vertices;
    gpu::Samplers m_samplers;
};

/// The gain for a given largest difference: a power of two, 1 to 256. At 256, half an 8-bit level
/// reaches white.
double gain_for(double largest);
