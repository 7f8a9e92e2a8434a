#include "model/plan/plan_memory.h"

#include <doctest/doctest.h>

TEST_CASE("the memory of a plan is that of its targets and of the picture read back") {
    // 100 x 10 texels of 8 bytes, two slots. The picture that is read back takes 20 bytes per
    // pixel.
    Plan plan;
    plan.targets.push_back({.extent = {100, 10}, .format = Format::rgba16f, .slots = 2});
    CHECK(estimated_bytes(plan, {100, 10}) == 2 * 8000 + 20 * 1000);
    plan.targets.push_back({.extent = {30, 10}, .format = Format::rgba16f, .mipmapped = true});
    CHECK(estimated_bytes(plan, {1, 1}) == 2 * 8000 + 2400 + 800 + 20);
    plan.targets.push_back({.extent = {100, 10}, .onto = 0});
    plan.targets.push_back({.extent = {100, 10}, .is_unused = true});
    CHECK(estimated_bytes(plan, {1, 1}) == 2 * 8000 + 2400 + 800 + 20);
    plan.targets.push_back({.extent = {100, 10}, .slots = 1, .common = 0});
    plan.common.push_back({{100, 10}});
    CHECK(estimated_bytes(plan, {1, 1}) == 3 * 8000 + 2400 + 800 + 20);
}
