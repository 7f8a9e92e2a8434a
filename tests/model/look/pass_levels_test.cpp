#include "model/look/pass_levels.h"

#include <doctest/doctest.h>

namespace {
using LevelCounts = std::vector<std::size_t>;

SizedName sized(const std::string& name, int width, int height) {
    return {name, {width, height}};
}
}  // namespace

TEST_CASE("consecutively numbered passes that only shrink or only grow are levels of a pyramid") {
    const std::vector<SizedName> passes{
        sized("beam", 64, 48), sized("down_1", 32, 24), sized("down_2", 16, 12),
        sized("down_3", 8, 6), sized("up_2", 16, 12),   sized("up_1", 32, 24),
        sized("up_0", 64, 48), sized("last", 64, 48),
    };
    CHECK(count_levels(passes) == LevelCounts{1, 3, 3, 1});
}

TEST_CASE("numbered passes without monotonic sizes or consecutive numbers are not a pyramid") {
    CHECK(count_levels(std::vector{sized("pass1", 64, 48), sized("pass2", 64, 48),
                                   sized("pass3", 64, 48)}) == LevelCounts{1, 1, 1});
    CHECK(count_levels(std::vector{sized("pass1", 64, 48), sized("pass2", 32, 24),
                                   sized("pass3", 64, 48)}) == LevelCounts{1, 1, 1});
    CHECK(count_levels(std::vector{sized("pass1", 64, 48), sized("pass3", 32, 24),
                                   sized("pass5", 16, 12)}) == LevelCounts{1, 1, 1});
    CHECK(count_levels(std::vector{sized("pass1", 64, 48), sized("pass2", 32, 64),
                                   sized("pass3", 16, 80)}) == LevelCounts{1, 1, 1});
}

TEST_CASE("two passes, different stems and bare numbers are not a pyramid") {
    CHECK(count_levels(std::vector{sized("a1", 64, 48), sized("a2", 32, 24)}) == LevelCounts{1, 1});
    CHECK(count_levels(std::vector{sized("a1", 64, 48), sized("b2", 32, 24),
                                   sized("c3", 16, 12)}) == LevelCounts{1, 1, 1});
    CHECK(count_levels(std::vector{sized("crt/1", 64, 48), sized("crt/2", 32, 24),
                                   sized("crt/3", 16, 12)}) == LevelCounts{1, 1, 1});
    CHECK(count_levels(std::vector{sized("crt/a1", 64, 48), sized("crt/a2", 32, 24),
                                   sized("crt#2/a3", 16, 12)}) == LevelCounts{1, 1, 1});
    CHECK(count_levels(std::vector{sized("a1", 64, 48), sized("a99999999999", 32, 24),
                                   sized("a3", 16, 12)}) == LevelCounts{1, 1, 1});
}

TEST_CASE("a pyramid ends where its numbers change direction") {
    CHECK(count_levels(std::vector{sized("a1", 64, 48), sized("a2", 32, 24), sized("a3", 16, 12),
                                   sized("a2", 8, 6)}) == LevelCounts{3, 1});
    CHECK(count_levels(std::vector{sized("a9", 64, 48), sized("a10", 32, 24),
                                   sized("a11", 16, 12)}) == LevelCounts{3});
}
