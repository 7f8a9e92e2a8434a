#include "ui/widgets/tooltip_place.h"

#include <doctest/doctest.h>

namespace {
constexpr Rect window{0, 0, 1000, 800};
constexpr TooltipSize size{200, 60, 10, 300};

struct Corner {
    float left, top;
    bool operator==(const Corner&) const = default;
};

Corner corner(const Rect& item, const Rect& pane, const TooltipSize& tooltip = size) {
    const Rect place = tooltip_place(item, pane, window, tooltip);
    return {place.left, place.top};
}
}  // namespace

TEST_CASE("a tooltip lies beside its pane, at the height of its item") {
    CHECK(corner({10, 100, 180, 20}, {0, 30, 200, 700}) == Corner{210, 100});    // right of it
    CHECK(corner({810, 100, 90, 20}, {800, 30, 200, 700}) == Corner{590, 100});  // left of it
    CHECK(corner({10, 780, 180, 20}, {0, 30, 200, 770}) == Corner{210, 740});    // in the window
}

TEST_CASE("a tooltip of a wide pane lies below or above the pane") {
    CHECK(corner({500, 35, 20, 20}, {0, 30, 1000, 30}) == Corner{500, 70});
    CHECK(corner({500, 775, 20, 20}, {0, 770, 1000, 30}) == Corner{500, 700});
    CHECK(corner({950, 35, 20, 20}, {0, 30, 1000, 30}) == Corner{800, 70});  // in the window
}

TEST_CASE("a tooltip in the middle of a large pane lies above its item, not over the next one") {
    CHECK(corner({500, 400, 20, 20}, {0, 0, 1000, 800}) == Corner{500, 330});
    // There is no room above an item at the top.
    CHECK(corner({500, 5, 20, 20}, {0, 0, 1000, 800}) == Corner{500, 35});
}
