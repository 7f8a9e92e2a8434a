#pragma once

#include "gpu/objects/canvas.h"
#include "gpu/objects/download.h"
#include "gpu/objects/samplers.h"
#include "gpu/objects/vertex_array.h"
#include "gpu/program.h"
#include "model/look/picture.h"
#include "model/picture/flash.h"

#include <memory>
#include <optional>
#include <utility>
#include <vector>

/// The mean light of the cells of a picture, for counting flashes.
class LightCells {
public:
    /// Builds the program that draws the cells.
    static Result<gpu::Program> make_program();
    /// Builds its own program.
    static Result<LightCells> make();
    explicit LightCells(std::shared_ptr<const gpu::Program> program)
        : m_program(std::move(program)) {}

    /// Draws the cells of a texture with this encoding from 64 samples per cell. False for integer
    /// formats and without memory; then there are no cells.
    bool draw(const gpu::Texture& from, Encoding encoding);
    /// The last drawn cells: linear light 0..1 in red, green and blue. Call it after draw().
    const gpu::Canvas& canvas() const { return *m_cells; }

private:
    std::shared_ptr<const gpu::Program> m_program;  // shared within a context
    gpu::VertexArray m_vertices;
    gpu::Samplers m_samplers;
    std::optional<gpu::Canvas> m_cells;
};

/// Whether reading the texture gives linear light, stored or decoded by GL.
bool holds_light(const gpu::Texture& texture, Encoding encoding);

/// The cells read back from the GPU, for a FlashCounter.
std::vector<Light> taken_cells(gpu::Download& download);
