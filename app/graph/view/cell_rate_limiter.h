#pragma once

#include "gpu/objects/canvas.h"
#include "gpu/objects/samplers.h"
#include "gpu/objects/vertex_array.h"
#include "gpu/program.h"
#include "model/look/picture.h"
#include "model/picture/flash.h"

#include <array>
#include <optional>

/// Limits how fast large parts of a displayed picture change their light. The light of each cell of
/// LightCells follows the picture at a limited rate. Brighter parts are dimmed to it, and darker
/// ones are lightened. Small or static parts stay unchanged.
class CellRateLimiter {
public:
    static Result<CellRateLimiter> make();

    struct Asked {
        const gpu::Texture& picture;
        Encoding encoding;
        const gpu::Texture& cells;  // of this picture
        Light maximum;              // maximum change of a cell's light now, 0..1
    };
    /// The limited picture in its own encoding, size and format; null without memory.
    const gpu::Texture* limit(const Asked& asked);
    /// The next picture is displayed unchanged.
    void start_again() { m_is_new = true; }

private:
    CellRateLimiter(gpu::Program follower, gpu::Program shower)
        : m_follower(std::move(follower)), m_shower(std::move(shower)) {}
    void follow(const gpu::Texture& cells, const Light& maximum);

    gpu::Program m_follower;
    gpu::Program m_shower;
    gpu::VertexArray m_vertices;
    gpu::Samplers m_samplers;
    std::array<std::optional<gpu::Canvas>, 2> m_allowed;
    std::size_t m_now = 0;
    std::optional<gpu::Canvas> m_shown;
    bool m_is_new = true;
};
