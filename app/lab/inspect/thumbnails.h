#pragma once

#include "gpu/objects/canvas.h"
#include "graph/executor/executor.h"
#include "graph/inspect/viewer.h"
#include "lab/inspect/round_robin.h"

#include <optional>
#include <string>
#include <vector>

/// Thumbnails of all passes of the open look, updated one at a time.
class Thumbnails {
public:
    /// Call it in every update while they are visible. `height` in device pixels.
    void update(Viewer& viewer, const Executor& executor, int height, double seconds);
    /// Discards all thumbnails; call it when they are hidden.
    void stop();

    /// Null: not drawn yet.
    const gpu::Texture* picture(std::size_t pass) const;
    /// Whether some thumbnails are outdated.
    bool is_pending() const { return m_round_robin.is_pending(); }

private:
    void draw(Viewer& viewer, const Executor& executor, std::size_t pass);

    std::vector<std::string> m_passes;  // to detect another look
    int m_height = 0;
    std::vector<std::optional<gpu::Texture>> m_pictures;
    RoundRobin m_round_robin;
};
