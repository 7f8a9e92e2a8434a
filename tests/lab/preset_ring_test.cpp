#include "lab/preset_ring.h"

#include <doctest/doctest.h>

namespace {
const std::vector<PresetEntry> presets{{"crt", "amber", "/p/amber.json", false},
                                       {"crt", "blue", "/p/blue.json", false}};
}

TEST_CASE("presets go round and round, and the look without one is among them") {
    CHECK(preset_beside(presets, "", 1) == PresetPlace{"/p/amber.json", 1});
    CHECK(preset_beside(presets, "/p/amber.json", 1) == PresetPlace{"/p/blue.json", 2});
    CHECK(preset_beside(presets, "/p/blue.json", 1) == PresetPlace{"", 0});
    CHECK(preset_beside(presets, "", -1) == PresetPlace{"/p/blue.json", 2});
    CHECK(preset_beside(presets, "/p/amber.json", -1) == PresetPlace{"", 0});
    CHECK(preset_beside(presets, "/p/amber.json", 4) == PresetPlace{"/p/blue.json", 2});
}

TEST_CASE("a preset from elsewhere has the first before it and the last behind it") {
    CHECK(preset_beside(presets, "/home/mine.json", 1) == PresetPlace{"/p/amber.json", 1});
    CHECK(preset_beside(presets, "/home/mine.json", -1) == PresetPlace{"/p/blue.json", 2});
    CHECK(preset_beside({}, "", 1) == PresetPlace{"", 0});
}
