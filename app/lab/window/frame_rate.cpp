#include "lab/window/frame_rate.h"

#include <algorithm>

double FrameRate::frame_seconds(double display_rate) const {
    return 1.0 / (cap > 0.0 ? cap : std::clamp(display_rate, 24.0, no_cap));
}
