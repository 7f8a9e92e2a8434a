#pragma once

#include "gpu/objects/canvas.h"
#include "gpu/objects/vertex_array.h"
#include "graph/compare/pair.h"
#include "model/preset/comparison.h"

/// Draws pictures for comparison. All canvases have a float format.
class Comparer {
public:
    static Result<Comparer> make();

    /// The difference of each number by `measure`, into a canvas of the same size.
    void draw_difference(const Pair& pair, DifferenceMeasure measure, const gpu::Canvas& to);
    /// A picture with its light multiplied by 2^stops, into a canvas of its size and encoding.
    void draw_brighter(const gpu::Texture& from, Encoding encoding, double stops,
                       const gpu::Canvas& to);
    /// A picture of another size: the whole picture, scaled to fit, centred in `to` with black
    /// around it. When shrunk it is averaged by area, when enlarged interpolated, both in linear
    /// light.
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
