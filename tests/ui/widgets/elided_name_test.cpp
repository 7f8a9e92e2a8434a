#include "ui/widgets/elided_name.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <vector>

namespace {
// Every character is one unit wide.
float length_of(const std::string& text) {
    return static_cast<float>(std::ranges::count_if(
        text, [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

std::string elided(const std::string& name, float maximum) {
    const std::vector<std::string> all{"beam",       "bloom_down_1",  "bloom_down_2",
                                       "bloom_up_1", "mask-vertical", "mask-horizontal-last",
                                       "blurHalf",   "blurWhole",     "größe 1",
                                       "größe 2"};
    return elided_to(elided_name(name, all), maximum, length_of);
}
}  // namespace

TEST_CASE("a name that fits is shown completely") {
    CHECK(elided("bloom_down_2", 12.0f) == "bloom_down_2");
    CHECK(elided("beam", 4.0f) == "beam");
}

TEST_CASE("the difference of names with equal beginnings is kept") {
    CHECK(elided("bloom_down_1", 10.0f) == "bloom_do…1");
    CHECK(elided("bloom_down_2", 10.0f) == "bloom_do…2");
    CHECK(elided("bloom_up_1", 7.0f) == "bl…up_1");
    CHECK(elided("mask-vertical", 9.0f) == "…vertical");
    CHECK(elided("blurHalf", 6.0f) == "b…Half");
    CHECK(elided("größe 2", 5.0f) == "grö…2");  // "ö" has two bytes
}

TEST_CASE("an end that does not fit is cut, and so is a unique name") {
    CHECK(elided("mask-horizontal-last", 9.0f) == "…horizon…");
    CHECK(elided("persistence", 6.0f) == "persi…");
    CHECK(elided("beam", 3.0f) == "be…");
}

TEST_CASE("names are split only between words") {
    const std::vector<std::string> others{"brightness", "red", "red_2"};
    CHECK(elided_name("brim", others).front.empty());
    CHECK(elided_name("red_2", others).front.empty());
    CHECK(elided_name("red_3", others).front == "red_");
    CHECK(elided_name("red_3", others).end == "3");
}

TEST_CASE("numbered passes are shown together, with their difference and their numbers") {
    const auto told_levels = [](float maximum, const std::vector<std::string>& others) {
        return elided_to(elided_name("bloom_down_", "1", "6", others), maximum, length_of);
    };
    CHECK(told_levels(14.0f, {"bloom_up_1"}) == "bloom_down 1–6");
    CHECK(told_levels(12.0f, {"bloom_up_1"}) == "blo…down 1–6");
    CHECK(told_levels(12.0f, {"beam"}) == "bloom_d… 1–6");
}
