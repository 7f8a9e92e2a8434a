#include "ui/widgets/truncated_text.h"

#include "in_a_moment.h"

#include <doctest/doctest.h>

#include <algorithm>

namespace {
// Every character is one unit wide, including the ellipsis.
float letters(const std::string& text) {
    return static_cast<float>(std::ranges::count_if(
        text, [](char byte) { return (static_cast<unsigned char>(byte) & 0xC0U) != 0x80U; }));
}
}  // namespace

TEST_CASE("a text that fits stays, and another one is cut with an ellipsis") {
    CHECK(truncated_to_width("", 3.0f, letters) == "");
    CHECK(truncated_to_width("abc", 3.0f, letters) == "abc");
    CHECK(truncated_to_width("abcd", 3.0f, letters) == "ab…");
    CHECK(truncated_to_width("abcd", 1.0f, letters) == "…");
    CHECK(truncated_to_width("abcd", 0.0f, letters) == "…");
    CHECK(truncated_to_width("äöüßé", 4.0f, letters) == "äöü…");
    for (std::size_t size : {63, 64, 65, 127, 128, 129, 1000})
        CHECK(truncated_to_width(times(size, "ä"), 50.0f, letters) == times(49, "ä") + "…");
    CHECK(truncated_to_width(times(200, "x"), 128.0f, letters) == times(127, "x") + "…");
    CHECK(truncated_to_width(times(200, "x"), 200.0f, letters) == times(200, "x"));
}

TEST_CASE("of a very long line little more than the fitting part is measured") {
    const std::string line = times(1'000'000, "+1.0");
    double measured = 0.0;
    const auto width_of = [&measured](const std::string& text) {
        measured += static_cast<double>(text.size());
        return letters(text);
    };
    CHECK(truncated_to_width(line, 100.0f, width_of).size() == 99 + std::string("…").size());
    CHECK(measured < 4096.0);
}
