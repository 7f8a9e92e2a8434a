#pragma once

#include "gpu/objects/canvas.h"
#include "gpu/objects/samplers.h"
#include "gpu/objects/vertex_array.h"
#include "gpu/program.h"

#include <optional>

/// The number of mip levels of a texture, including the largest.
int level_count(const gpu::Texture& texture);
/// The size of a level; at least 1 x 1.
Extent level_extent(Extent largest, int level);

/// Copies a mip level into a separate texture, so that all code that reads textures can read it.
class LevelCopy {
public:
    static Result<LevelCopy> make();

    /// In the format of the texture; sRGB texels become linear light in floats. Null if the level
    /// does not exist, for integer formats and without memory. Valid until the next call.
    const gpu::Texture* draw(const gpu::Texture& from, int level);

private:
    explicit LevelCopy(gpu::Program program) : m_program(std::move(program)) {}

    gpu::Program m_program;
    gpu::VertexArray m_vertices;
    gpu::Samplers m_samplers;
    std::optional<gpu::Canvas> m_canvas;
};
