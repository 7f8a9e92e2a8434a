// Flashes of sub-frames: black frames at 60 source frames per second are seen as steady light.
#include "model/picture/subframe_cells.h"

#include "model/picture/flash_log.h"

#include <doctest/doctest.h>

namespace {
std::vector<Light> cells_of_light(float light) {
    return std::vector<Light>(static_cast<std::size_t>(flash_cells.width * flash_cells.height),
                              Light{light, light, light});
}
}  // namespace

TEST_CASE("the cells of a source frame are the mean of its sub-frames") {
    SubframeCells cells;
    CHECK_FALSE(cells.add({0, 4}, cells_of_light(1.0f)));
    CHECK_FALSE(cells.add({1, 4}, cells_of_light(0.6f)));
    CHECK_FALSE(cells.add({2, 4}, cells_of_light(0.0f)));
    const auto whole = cells.add({3, 4}, cells_of_light(0.0f));
    REQUIRE(whole);
    CHECK((*whole)[7][1] == doctest::Approx(0.4f));
    CHECK(cells.add({0, 1}, cells_of_light(0.3f)) == cells_of_light(0.3f));
}

TEST_CASE("a source frame with missing sub-frames is dropped") {
    SubframeCells cells;
    CHECK_FALSE(cells.add({1, 2}, cells_of_light(1.0f)));
    CHECK_FALSE(cells.add({0, 2}, cells_of_light(1.0f)));
    CHECK_FALSE(cells.add({0, 2}, cells_of_light(0.5f)));
    CHECK(cells.add({1, 2}, cells_of_light(0.5f)) == cells_of_light(0.5f));
}

TEST_CASE("black frames flash, unless they are sub-frames") {
    FlashLog separate;
    FlashLog joined;
    for (int frame = 1; frame <= 240; ++frame) {
        const auto cells = cells_of_light(frame % 2 == 1 ? 1.0f : 0.0f);
        separate.add(cells, frame / 120.0);
        joined.add(cells, frame / 120.0, subframe_of(frame, 2));
    }
    CHECK(separate.warning());
    CHECK_FALSE(joined.warning());
}
