#include "ui/widgets/line_breaks.h"

#include <doctest/doctest.h>

namespace {
// Every character is one unit wide.
std::string broken(const std::string& text, float maximum) {
    return broken_at_blanks(
        text, maximum, [](const std::string& line) { return static_cast<float>(line.size()); });
}
}  // namespace

TEST_CASE("lines break at spaces, never within a number") {
    CHECK(broken("255 levels, 0.41 on average", 14.0f) == "255 levels,\n0.41 on\naverage");
    CHECK(broken("0.41", 2.0f) == "0.41");
    CHECK(broken("one two", 7.0f) == "one two");
    CHECK(broken("one two", 6.0f) == "one\ntwo");
    CHECK(broken("", 6.0f).empty());
}

TEST_CASE("existing line breaks stay") {
    CHECK(broken("a b\nc d", 9.0f) == "a b\nc d");
    CHECK(broken("a\n\nb", 9.0f) == "a\n\nb");
}
