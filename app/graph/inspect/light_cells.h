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

/// The mean light of the parts of a picture, as flashes are counted in them.
class LightCells {
public:
    /// What they are drawn with.
    static Result<gpu::Program> make_program();
    /// With a program of its own.
    static Result<LightCells> make();
    explicit LightCells(std::shared_ptr<const gpu::Program> program)
        : m_program(std::move(program)) {}

    /// Draws the cells of a texture whose numbers have this encoding: 64 places of each cell are
    /// read. False without memory: then there are none.
    bool draw(const gpu::Texture& from, Encoding encoding);
    /// As drawn last: linear light 0..1 in red, green and blue. To be called after draw().
    const gpu::Canvas& canvas() const { return *m_cells; }

private:
    std::shared_ptr<const gpu::Program> m_program;  // of who looks in the same context
    gpu::VertexArray m_vertices;
    gpu::Samplers m_samplers;
    std::optional<gpu::Canvas> m_cells;
};

/// Whether reading the texture gives linear light, be it because GL decodes it.
bool holds_light(const gpu::Texture& texture, Encoding encoding);

/// The cells that have come back from the GPU, for a FlashCounter.
std::vector<Light> taken_cells(gpu::Download& download);
