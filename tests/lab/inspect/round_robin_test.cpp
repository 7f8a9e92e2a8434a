#include "lab/inspect/round_robin.h"

#include <doctest/doctest.h>

#include <vector>

namespace {
// The index that was due at each time, or -1. The picture changes each time if `is_moving`.
std::vector<int> updates(RoundRobin& round_robin, const std::vector<double>& times,
                         bool is_moving) {
    static std::uint64_t picture = 1;
    std::vector<int> had;
    for (const double seconds : times) {
        picture += is_moving ? 1 : 0;
        const auto due = round_robin.due(picture, seconds);
        had.push_back(due ? static_cast<int>(*due) : -1);
        if (due)
            round_robin.done(seconds);
    }
    return had;
}
using Had = std::vector<int>;
}  // namespace

TEST_CASE("new entries are due at once, then one at a time five times per second") {
    RoundRobin round_robin;
    round_robin.restart(3);
    CHECK(updates(round_robin, {1.0, 1.01, 1.02}, true) == Had{0, 1, 2});
    CHECK(updates(round_robin, {1.1, 1.21, 1.23, 1.3, 1.4, 1.44, 1.65}, true) ==
          Had{-1, -1, 0, -1, -1, 1, 2});
}

TEST_CASE("in a static picture each outdated entry is due once, then none") {
    RoundRobin round_robin;
    round_robin.restart(2);
    updates(round_robin, {1.0, 1.01, 1.3}, true);
    CHECK(round_robin.is_pending());
    CHECK(updates(round_robin, {1.35, 1.46, 1.47, 1.48, 9.0}, false) == Had{-1, 1, -1, -1, -1});
    CHECK_FALSE(round_robin.is_pending());
    CHECK(updates(round_robin, {9.1, 9.31}, true) == Had{0, 1});
}

TEST_CASE("a slow refresh is followed by a pause ten times as long") {
    RoundRobin round_robin;
    round_robin.restart(1);
    REQUIRE(round_robin.due(1, 5.0));
    round_robin.done(5.0, 0.5);
    CHECK_FALSE(round_robin.due(2, 9.9));
    CHECK(round_robin.due(3, 10.0));
}

TEST_CASE("without entries nothing is due") {
    RoundRobin round_robin;
    round_robin.restart(0);
    CHECK_FALSE(round_robin.due(1, 1.0));
    CHECK_FALSE(round_robin.is_pending());
}
