#include "graph/warm_up/warm_up_sizes.h"

#include "graph/looks.h"
#include "graph/warm_up/power_of_two.h"
#include "model/plan/plan.h"

#include <doctest/doctest.h>

namespace {
Look scaled(const std::vector<double>& factors) {
    std::vector<Pass> passes;
    for (const double factor : factors) {
        passes.push_back(pass("p" + std::to_string(passes.size()), "void main() {}\n"));
        passes.back().size[0].factor = passes.back().size[1].factor = factor;
    }
    return look_of(std::move(passes));
}

// For each target, whether its sides are powers of two.
std::vector<std::pair<bool, bool>> kinds(const Look& look, const PictureSizes& sizes) {
    std::vector<std::pair<bool, bool>> found;
    const auto plan = plan_targets(look, sizes.viewport, sizes.source, {}).value();
    for (const PlannedTarget& target : plan.targets)
        found.emplace_back(is_power_of_two(target.extent.width),
                           is_power_of_two(target.extent.height));
    return found;
}
}  // namespace

TEST_CASE(
    "scaled targets of a substitute size are powers of two only where those of the picture are") {
    const PictureSizes whole{{1280, 720}, {320, 240}};  // a third: 427 x 240; a twelfth: 107 x 60
    const Look look = scaled({1.0 / 3.0, 1.0 / 12.0, 1.0});
    CHECK(kinds(look, {{96, 96}, {96, 96}}) != kinds(look, whole));  // its third is 32
    for (const PictureSizes& sizes :
         {small_equivalent(look, whole), quarter_equivalent(look, whole).value()}) {
        CHECK(kinds(look, sizes) == kinds(look, whole));
        CHECK(sizes.viewport.width <= 328);
    }
}

TEST_CASE("power-of-two sides of the picture stay powers of two in a substitute size") {
    const PictureSizes whole{{1024, 768}, {320, 240}};  // halves: 512 x 384
    const Look look = scaled({1.0, 0.5});
    const PictureSizes small = small_equivalent(look, whole);
    CHECK(small.viewport == Extent{64, 96});
    CHECK(kinds(look, small) == kinds(look, whole));
    CHECK(quarter_equivalent(look, whole).value().viewport == Extent{256, 192});
}

TEST_CASE("a small picture has no quarter-size substitute") {
    CHECK_FALSE(quarter_equivalent(scaled({1.0}), {{300, 200}, {320, 240}}).has_value());
}
