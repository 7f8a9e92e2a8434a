#pragma once

#include "gpu/objects/canvas.h"
#include "gpu/objects/vertex_array.h"
#include "graph/compare/pair.h"
#include "model/preset/comparison.h"

/// Draws what a person compares two pictures by. Every canvas is one of floats.
class Comparer {
public:
    static Result<Comparer> make();

    /// How far the two are apart, number by number, into a canvas of their size.
    void draw_difference(const Pair& pair, DifferenceMeasure measure, const gpu::Canvas& to);
    /// A picture with its light multiplied by two to the power of `stops`, into a canvas of its
    /// size and in its encoding.
    void draw_brighter(const gpu::Texture& from, Encoding encoding, double stops,
                       const gpu::Canvas& to);
    /// A picture of another size: all of it, as large as fits in the middle of `to`, black around
    /// it. Smaller ones are averaged by area, larger ones interpolated, both as light.
    void draw_fitted(const gpu::Texture& from, Encoding from_encoding, const gpu::Canvas& to,
                     Encoding to_encoding);

private:
    Comparer(gpu::Program difference, gpu::Program brighter, gpu::Program fitted);
    void draw_single(const gpu::Texture& from, const gpu::Program& program, const gpu::Canvas& to);

    gpu::Program m_difference;
    gpu::Program m_brighter;
    gpu::Program m_fitted;
    gpu::VertexArray m_vertices;
    gpu::Samplers m_samplers;
};
