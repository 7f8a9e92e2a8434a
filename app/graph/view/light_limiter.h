#pragma once

#include "gpu/objects/canvas.h"
#include "gpu/objects/samplers.h"
#include "gpu/objects/vertex_array.h"
#include "gpu/program.h"
#include "model/look/picture.h"
#include "model/picture/flash.h"

#include <array>
#include <optional>

/// Shows a picture whose large parts change their light no faster than is comfortable. Each cell of
/// LightCells has a light that follows the picture's at a limited rate; a part that is brighter
/// than that is dimmed, a darker one gets a veil of light. What is small or still stays as it is.
class LightLimiter {
public:
    static Result<LightLimiter> make();

    struct Asked {
        const gpu::Texture& picture;
        Encoding encoding;
        const gpu::Texture& cells;  // of this picture
        Light most;                 // that a cell's light may change now, 0..1
    };
    /// The picture as it may be shown, in its own encoding, size and format; null without memory.
    const gpu::Texture* limit(const Asked& asked);
    /// The next picture is shown as it is.
    void start_again() { m_is_new = true; }

private:
    LightLimiter(gpu::Program follower, gpu::Program shower)
        : m_follower(std::move(follower)), m_shower(std::move(shower)) {}
    void follow(const gpu::Texture& cells, const Light& most);

    gpu::Program m_follower;
    gpu::Program m_shower;
    gpu::VertexArray m_vertices;
    gpu::Samplers m_samplers;
    std::array<std::optional<gpu::Canvas>, 2> m_allowed;
    std::size_t m_now = 0;
    std::optional<gpu::Canvas> m_shown;
    bool m_is_new = true;
};
