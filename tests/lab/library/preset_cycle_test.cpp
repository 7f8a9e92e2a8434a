#include "lab/library/preset_cycle.h"

#include <doctest/doctest.h>

namespace {
const std::vector<PresetEntry> presets{{"crt", "amber", "/p/amber.json", false, "amber"},
                                       {"crt", "blue", "/p/blue.json", false, "blue"}};
const std::vector<PresetEntry> five{{"crt", "a", "/p/a.json", false, "a"},
                                    {"crt", "b", "/p/b.json", false, "b"},
                                    {"crt", "c", "/p/c.json", false, "c"},
                                    {"crt", "d", "/p/d.json", false, "d"},
                                    {"crt", "e", "/p/e.json", false, "e"}};
}  // namespace

TEST_CASE("presets form a ring that includes the look's defaults") {
    CHECK(preset_after(presets, "", 1) == PresetIndex{"/p/amber.json", 1, 2});
    CHECK(preset_after(presets, "/p/amber.json", 1) == PresetIndex{"/p/blue.json", 2, 2});
    CHECK(preset_after(presets, "/p/blue.json", 1) == PresetIndex{"", 0, 2});
    CHECK(preset_after(presets, "", -1) == PresetIndex{"/p/blue.json", 2, 2});
    CHECK(preset_after(presets, "/p/amber.json", -1) == PresetIndex{"", 0, 2});
    CHECK(preset_after(presets, "/p/amber.json", 4) == PresetIndex{"/p/blue.json", 2, 2});
}

TEST_CASE("next to a preset from elsewhere are the first and the last preset") {
    CHECK(preset_after(presets, "/home/mine.json", 1) == PresetIndex{"/p/amber.json", 1, 2});
    CHECK(preset_after(presets, "/home/mine.json", -1) == PresetIndex{"/p/blue.json", 2, 2});
    CHECK(preset_after({}, "", 1) == PresetIndex{"", 0, 0});
}

TEST_CASE("with favourites only, other presets and the defaults are skipped") {
    const FavouritePresets stars{"crt/b", "crt/d", "phosphor/c"};
    const PresetIndex b{"/p/b.json", 1, 2};
    const PresetIndex d{"/p/d.json", 2, 2};
    CHECK(favourite_after(five, stars, "/p/b.json", 1) == d);
    CHECK(favourite_after(five, stars, "/p/b.json", -1) == d);
    CHECK(favourite_after(five, stars, "/p/d.json", 1) == b);
    CHECK(favourite_after(five, stars, "/p/b.json", 2) == b);
    CHECK(favourite_after(five, stars, "/p/c.json", 1) == d);  // between two favourites
    CHECK(favourite_after(five, stars, "/p/c.json", -1) == b);
    for (const char* open : {"", "/p/a.json", "/p/e.json"}) {
        CHECK(favourite_after(five, stars, open, 1) == b);
        CHECK(favourite_after(five, stars, open, -1) == d);
    }
    CHECK_FALSE(favourite_after(five, {"phosphor/c"}, "", 1));
}
