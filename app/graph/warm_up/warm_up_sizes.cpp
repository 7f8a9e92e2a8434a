#include "graph/warm_up/warm_up_sizes.h"

#include "graph/warm_up/power_of_two.h"
#include "model/plan/plan.h"

#include <algorithm>

namespace {
// Whether drivers treat the targets of both plans alike.
bool are_alike(const Plan& one, const Plan& other) {
    return std::ranges::equal(
        one.targets, other.targets, [](const PlannedTarget& a, const PlannedTarget& b) {
            return is_power_of_two(a.extent.width) == is_power_of_two(b.extent.width) &&
                   is_power_of_two(a.extent.height) == is_power_of_two(b.extent.height);
        });
}

// The first sizes from `about` on, up to `maximum` texels larger, whose kinds of targets are those
// of `whole`.
std::optional<PictureSizes> alike(const Look& look, const PictureSizes& whole,
                                  const PictureSizes& about, int maximum) {
    const auto wanted = plan_targets(look, whole.viewport, whole.source, {});
    for (int more = 0; wanted && more <= maximum; ++more) {
        const PictureSizes sizes{{about.viewport.width + more, about.viewport.height + more},
                                 about.source};
        const auto plan = plan_targets(look, sizes.viewport, sizes.source, {});
        if (plan && are_alike(*wanted, *plan))
            return sizes;
    }
    return std::nullopt;
}
}  // namespace

PictureSizes small_equivalent(const Look& look, const PictureSizes& whole) {
    const auto side = [](int length) { return is_power_of_two(length) ? 64 : 96; };
    const PictureSizes small{{side(whole.viewport.width), side(whole.viewport.height)}, {96, 96}};
    return alike(look, whole, small, 32).value_or(small);
}

std::optional<PictureSizes> quarter_equivalent(const Look& look, const PictureSizes& whole) {
    constexpr int minimum = 128;
    const Extent quarter{whole.viewport.width / 4, whole.viewport.height / 4};
    if (std::min(quarter.width, quarter.height) < minimum)
        return std::nullopt;
    return alike(look, whole, {quarter, whole.source}, 7);
}
