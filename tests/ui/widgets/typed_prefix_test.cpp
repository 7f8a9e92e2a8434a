#include "ui/widgets/typed_prefix.h"

#include <doctest/doctest.h>

TEST_CASE("the first item that starts with the typed letters is found, once") {
    TypedPrefix prefix;
    CHECK_FALSE(prefix.is_found("P1"));
    prefix.add("p", 10.0);
    CHECK_FALSE(prefix.is_found("Custom"));
    CHECK(prefix.is_found("P1"));
    CHECK_FALSE(prefix.is_found("P2"));
}

TEST_CASE("letters add up until a pause of a second") {
    TypedPrefix prefix;
    prefix.add("p", 10.0);
    prefix.add("3", 10.9);
    CHECK_FALSE(prefix.is_found("P1"));
    CHECK(prefix.is_found("P31"));
    prefix.add("c", 12.0);
    CHECK(prefix.is_found("Custom"));
}

TEST_CASE("a frame without letters, and a longer text than the label, find nothing") {
    TypedPrefix prefix;
    prefix.add("", 1.0);
    CHECK_FALSE(prefix.is_found(""));
    prefix.add("custom", 1.0);
    CHECK_FALSE(prefix.is_found("Cus"));
}
