#include "io/sound/level_ramp.h"

#include <algorithm>
#include <cmath>

void LevelRamp::apply(std::span<float> stereo) noexcept {
    const double goal = m_goal;
    const std::size_t frames = stereo.size() / 2;
    for (std::size_t frame = 0; frame < frames; ++frame) {
        const double part = static_cast<double>(frame) / static_cast<double>(frames);
        const auto level = static_cast<float>(std::lerp(m_now, goal, part));
        for (float& sample : stereo.subspan(2 * frame, 2))
            sample = std::clamp(sample * level, -1.0f, 1.0f);
    }
    m_now = goal;
}
