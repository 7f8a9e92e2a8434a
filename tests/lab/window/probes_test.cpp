#include "lab/window/probes.h"

#include <doctest/doctest.h>

TEST_CASE("a pinned pixel is the same point in targets of every size") {
    const Pin pin = pin_at({"beam", 100, 30, false, {400, 60}});
    CHECK(pin.texel({400, 60}) == std::array{100, 30});
    CHECK(pin.texel({200, 30}) == std::array{50, 15});
    CHECK(pin.texel({1200, 180}) == std::array{301, 91});
    CHECK(pin.texel({1, 1}) == std::array{0, 0});
    CHECK(Pin{1.0, 1.0}.texel({400, 60}) == std::array{399, 59});
}
