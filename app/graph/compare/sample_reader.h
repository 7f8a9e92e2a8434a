#pragma once

#include "gpu/objects/canvas.h"
#include "gpu/objects/samplers.h"
#include "gpu/objects/vertex_array.h"
#include "gpu/program.h"
#include "model/look/picture.h"
#include "model/photo/samples.h"

#include <optional>

/// Reads the samples of a picture that a photo is compared with, and nothing else, from the GPU.
class SampleReader {
public:
    static Result<SampleReader> make();

    /// The linear light at the samples of a texture with this encoding. Waits for the GPU. Fails
    /// for integer formats and without memory.
    Result<ScreenLight> read(const gpu::Texture& texture, Encoding encoding,
                             const SampleLayout& layout);

private:
    SampleReader(gpu::Program tiles, gpu::Program cells)
        : m_tiles(std::move(tiles)), m_cells(std::move(cells)) {}
    void draw(const gpu::Program& program, const gpu::Texture& texture, Encoding encoding,
              const gpu::Canvas& canvas, const SampleLayout& layout);

    gpu::Program m_tiles;
    gpu::Program m_cells;
    gpu::VertexArray m_vertices;
    gpu::Samplers m_samplers;
    std::optional<gpu::Canvas> m_tile_canvas;
    std::optional<gpu::Canvas> m_cell_canvas;
};
