#include "lab/frame/heavy_pass.h"

std::optional<std::size_t> heavy_pass(const PassTimes& times) {
    constexpr std::size_t enough_frames = 4;
    constexpr double most_milliseconds = 100000.0;  // times above are not plausible
    const std::size_t frames = times.frames();
    if (frames < enough_frames)
        return std::nullopt;
    for (std::size_t pass = 0; pass < times.passes(); ++pass) {
        std::size_t heavy = 0;
        for (std::size_t frame = frames - enough_frames; frame < frames; ++frame) {
            const double time = times.milliseconds(pass, frame);
            heavy += time > heavy_pass_milliseconds && time < most_milliseconds ? 1U : 0U;
        }
        if (heavy == enough_frames)
            return pass;
    }
    return std::nullopt;
}
