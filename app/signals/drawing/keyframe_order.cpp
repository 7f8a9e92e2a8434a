#include "signals/drawing/keyframe_order.h"

#include <algorithm>
#include <cmath>
#include <numeric>

std::size_t KeyframeOrder::steps() const {
    return std::max<std::size_t>(1, keyframes.size() - (loops ? 0 : 1));
}

KeyframeOrder::Moment KeyframeOrder::at(double seconds) const {
    const double step_seconds = hold_seconds + morph_seconds;
    if (keyframes.size() < 2 || step_seconds <= 0.0)
        return {};
    const double gone = std::max(seconds, 0.0);
    const double step = std::floor(gone / step_seconds);
    const auto count = static_cast<double>(steps());
    if (!loops && step >= count)
        return {steps() - 1, 1.0};
    const double within = gone - step * step_seconds - hold_seconds;
    const double even = within > 0.0 ? std::min(within / morph_seconds, 1.0) : 0.0;
    const double share = is_eased ? even * even * (3.0 - 2.0 * even) : even;
    return {static_cast<std::size_t>(std::fmod(step, count)), share};
}

KeyframeOrder order_of(KeyframePlay play, std::size_t count, std::size_t still_at) {
    KeyframeOrder order;
    if (play == KeyframePlay::still || count < 2) {
        order.keyframes = {std::min(still_at, std::max<std::size_t>(count, 1) - 1)};
        return order;
    }
    order.keyframes.resize(count);
    std::iota(order.keyframes.begin(), order.keyframes.end(), std::size_t{0});
    order.loops = play != KeyframePlay::once;
    if (play == KeyframePlay::back_and_forth)
        for (std::size_t i = count - 1; i-- > 1;)
            order.keyframes.push_back(i);
    return order;
}
