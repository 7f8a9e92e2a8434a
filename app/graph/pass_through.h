#pragma once

#include "gpu/canvas.h"
#include "gpu/program.h"
#include "gpu/samplers.h"
#include "gpu/vertex_array.h"

#include <vector>

/// Draws what a texture holds over the whole of a target of any size and format: what a bypassed
/// pass does. Numbers stay as they are; of lights an integer target takes the whole part.
class PassThrough {
public:
    static Result<PassThrough> make();

    /// Within a gpu::DrawScope. Flipped, the first row of the one is the last of the other.
    void draw(const gpu::Texture& from, const Sampler& sampler, const gpu::Canvas& to,
              gpu::Samplers& samplers, bool is_flipped = false) const;

private:
    explicit PassThrough(std::vector<gpu::Program> programs) : m_programs(std::move(programs)) {}

    std::vector<gpu::Program>
        m_programs;  // from floats, from naturals; then the same into naturals
    gpu::VertexArray m_vertices;
};
