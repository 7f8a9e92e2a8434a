#include "ui/passes/strip_layout.h"

#include <doctest/doctest.h>

namespace {
using Widths = std::vector<float>;

constexpr AskedWidth pass{.minimum = 70.0f, .wanted = 100.0f, .best = 160.0f};
constexpr AskedWidth pyramid{
    .minimum = 60.0f, .wanted = 300.0f, .best = 300.0f, .is_pass = false};  // of six levels
}  // namespace

TEST_CASE("the strip shows full pass labels before a pyramid exceeds its minimum") {
    const std::vector<AskedWidth> asked{pass, pyramid, pass};
    const StripWidths room = strip_widths(asked, 260.0f);
    CHECK_FALSE(room.is_narrow);
    CHECK(room.widths == Widths{100.0f, 60.0f, 100.0f});
    CHECK(strip_widths(asked, 300.0f).widths == Widths{120.0f, 60.0f, 120.0f});
    CHECK(strip_widths(asked, 380.0f).widths == Widths{160.0f, 60.0f, 160.0f});
    CHECK(strip_widths(asked, 500.0f).widths == Widths{160.0f, 180.0f, 160.0f});
    CHECK(strip_widths(asked, 900.0f).widths == Widths{160.0f, 300.0f, 160.0f});
}

TEST_CASE("a strip without room for all labels gives each the same share of the missing width") {
    const std::vector<AskedWidth> asked{pass, pyramid, pass};
    const StripWidths room = strip_widths(asked, 230.0f);  // 30 of 300 above the minimum
    CHECK(room.is_narrow);
    CHECK(room.widths == Widths{73.0f, 84.0f, 73.0f});
}

TEST_CASE("a strip that is shorter than the minimum extends beyond its end") {
    const std::vector<AskedWidth> asked{pass, pass, pass};
    const StripWidths room = strip_widths(asked, 150.0f);
    CHECK(room.is_narrow);
    CHECK(room.widths == Widths{70.0f, 70.0f, 70.0f});
    CHECK(strip_widths({}, 150.0f).widths.empty());
}
