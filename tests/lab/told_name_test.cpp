#include "lab/told_name.h"

#include <doctest/doctest.h>

TEST_CASE("a look's manifest is told with its folder, any other file by its name") {
    CHECK(told_name("/home/ann/looks/crt/look.json") == "crt/look.json");
    CHECK(told_name("look.json") == "look.json");
    CHECK(told_name("/home/ann/looks/crt/beam.frag") == "beam.frag");
    CHECK(told_name({}).empty());
}
