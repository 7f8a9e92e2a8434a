#include "lab/rendering/frame_times.h"

#include <algorithm>
#include <numeric>

void FrameTimes::add(Executor& picture, const Drawn& drawn) {
    m_point_count = drawn.points;
    m_pass_milliseconds = picture.drawer().pass_milliseconds();
    m_passes.add(m_pass_milliseconds);
    m_gpu_seconds = (drawn.has_variant ? 2.0 : 1.0) *
                    std::accumulate(m_pass_milliseconds.begin(), m_pass_milliseconds.end(), 0.0) /
                    1000.0;
    add_beam(picture.look(), drawn);
    constexpr double smoothing = 0.1;
    m_frame_seconds += smoothing * (drawn.wall_seconds - m_frame_seconds);
}

void FrameTimes::add_beam(const Look& look, const Drawn& drawn) {
    double milliseconds = 0.0;
    for (std::size_t i = 0; i < std::min(look.passes.size(), m_pass_milliseconds.size()); ++i)
        if (is_of_beam(look.passes[i].draw))
            milliseconds += m_pass_milliseconds[i];
    if (drawn.has_variant)
        milliseconds *= 2.0;
    const double cost = milliseconds / 1000.0 / std::max(drawn.span_seconds, 1e-6);
    constexpr double smoothing = 0.2;  // the driver's times are some frames old
    m_beam_cost = m_beam_cost == 0.0 ? cost : m_beam_cost + smoothing * (cost - m_beam_cost);
}
