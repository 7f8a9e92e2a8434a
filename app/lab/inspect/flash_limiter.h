#pragma once

#include "graph/inspect/light_cells.h"
#include "graph/view/cell_rate_limiter.h"
#include "model/picture/flash_limit.h"

#include <array>
#include <optional>

/// The flash limiter for displayed views: two side by side and the output window, each with its own
/// history.
class FlashLimiter {
public:
    static Result<FlashLimiter> make();

    /// The limited picture of a view, display-encoded; the picture itself if the limiter is off.
    /// Times must increase.
    const gpu::Texture& shown(std::size_t view, const gpu::Texture& picture,
                              const FlashLimit& clamp, double seconds);
    /// Reports that the picture changes. The limited picture follows for some time after the last
    /// change.
    void note_moving(const FlashLimit& clamp, double seconds);
    /// Whether the limited picture may still be changing towards a static picture.
    bool is_transitioning(double seconds) const { return seconds < m_transition_end; }

private:
    struct View {
        LightCells cells;
        CellRateLimiter limiter;
        std::optional<double> latest = {};
    };
    using Views = std::array<std::optional<View>, 3>;
    explicit FlashLimiter(Views views) : m_views(std::move(views)) {}

    Views m_views;
    double m_transition_end = 0.0;  // s
};
