#pragma once

#include "graph/inspect/light_cells.h"
#include "graph/view/light_limiter.h"
#include "model/picture/comfort_clamp.h"

#include <array>
#include <optional>

/// Shows views under a person's clamp: the two that lie side by side and the output window's, each
/// with its own past.
class Comfort {
public:
    static Result<Comfort> make();

    /// What may be shown of a view that holds what a display is sent; the view itself where the
    /// clamp is off. Time goes up.
    const gpu::Texture& shown(std::size_t view, const gpu::Texture& picture,
                              const ComfortClamp& clamp, double seconds);
    /// The picture moves: what is shown follows it until some time after its last move.
    void note_moving(const ComfortClamp& clamp, double seconds);
    /// Whether what is shown may still be on its way to a picture that rests.
    bool is_settling(double seconds) const { return seconds < m_settled; }

private:
    struct View {
        LightCells cells;
        LightLimiter limiter;
        std::optional<double> latest = {};
    };
    using Views = std::array<std::optional<View>, 3>;
    explicit Comfort(Views views) : m_views(std::move(views)) {}

    Views m_views;
    double m_settled = 0.0;  // s
};
