#include "model/tuning/playlist.h"

#include <doctest/doctest.h>

#include <set>

TEST_CASE("a playlist repeats in its order, in both directions") {
    for (const auto& [step, index] : std::vector<std::pair<std::int64_t, std::size_t>>{
             {0, 0}, {4, 4}, {5, 0}, {-1, 4}, {-6, 4}})
        CHECK(playlist_index(step, 5, false, 1) == index);
    CHECK(playlist_index(7, 1, true, 1) == 0);
    CHECK(playlist_index(7, 2, true, 1) == 1);
}

TEST_CASE("a shuffled round has every preset once, and none follows itself") {
    for (const std::size_t count : {3, 4, 11}) {
        for (std::int64_t round = -5; round < 50; ++round) {
            std::set<std::size_t> seen;
            for (std::size_t i = 0; i < count; ++i) {
                const auto step =
                    round * static_cast<std::int64_t>(count) + static_cast<std::int64_t>(i);
                seen.insert(playlist_index(step, count, true, 42));
                CHECK(playlist_index(step, count, true, 42) !=
                      playlist_index(step - 1, count, true, 42));
            }
            CHECK(seen.size() == count);
        }
    }
}

TEST_CASE("rounds differ, and another seed gives another order") {
    std::set<std::vector<std::size_t>> orders;
    for (std::int64_t round = 0; round < 20; ++round) {
        std::vector<std::size_t> order;
        for (std::int64_t i = 0; i < 8; ++i)
            order.push_back(playlist_index(round * 8 + i, 8, true, 7));
        orders.insert(order);
    }
    CHECK(orders.size() == 20);  // of 40320
}
