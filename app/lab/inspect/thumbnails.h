#pragma once

#include "gpu/objects/canvas.h"
#include "graph/executor/executor.h"
#include "graph/inspect/viewer.h"
#include "lab/inspect/round_robin.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

/// Thumbnails of all passes of the open look, updated one at a time.
class Thumbnails {
public:
    /// Call it in every update while they are visible. `height` in device pixels; `seconds` is the
    /// time.
    void update(Viewer& viewer, const Executor& executor, const Values& values, int height,
                double seconds);
    /// Discards all thumbnails; call it when they are hidden.
    void stop();

    /// Null: not drawn yet.
    const gpu::Texture* picture(std::size_t pass) const;
    /// Whether values changed half a second ago or earlier, and the thumbnail shows the old ones.
    bool is_stale(std::size_t pass) const;
    /// Whether some thumbnails are outdated.
    bool is_pending() const { return m_round_robin.is_pending(); }

private:
    void follow_values(const Values& values, std::uint64_t picture);
    void draw(Viewer& viewer, const Executor& executor, std::size_t pass);

    std::vector<std::string> m_passes;  // to detect another look
    int m_height = 0;
    std::vector<std::optional<gpu::Texture>> m_pictures;
    Values m_values;
    bool m_has_other_values = false;                   // than those of the drawn picture
    std::uint64_t m_number = 0;                        // of the drawn picture
    double m_seconds = 0.0;                            // of the last update
    std::vector<std::optional<double>> m_outdated_at;  // nullopt: drawn with m_values
    RoundRobin m_round_robin;
};
