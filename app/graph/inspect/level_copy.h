#pragma once

#include "gpu/objects/canvas.h"
#include "gpu/objects/samplers.h"
#include "gpu/objects/vertex_array.h"
#include "gpu/program.h"

#include <optional>

/// How many levels a texture has, its largest among them.
int level_count(const gpu::Texture& texture);
/// The size of a level; at least 1 x 1.
Extent level_extent(Extent largest, int level);

/// One of a texture's smaller levels as a texture of its own, so that what reads textures reads it.
class LevelCopy {
public:
    static Result<LevelCopy> make();

    /// In the texture's own format; sRGB texels become light in floats. Null where there is no such
    /// level or no memory. Good until the next call.
    const gpu::Texture* draw(const gpu::Texture& from, int level);

private:
    explicit LevelCopy(gpu::Program program) : m_program(std::move(program)) {}

    gpu::Program m_program;
    gpu::VertexArray m_vertices;
    gpu::Samplers m_samplers;
    std::optional<gpu::Canvas> m_canvas;
};
