#include "lab/storage/told_name.h"

#include <doctest/doctest.h>

#include <cstdlib>

TEST_CASE("a look's manifest is shown with its folder, and any other file by its name") {
    CHECK(told_name("/home/ann/looks/crt/look.json") == "crt/look.json");
    CHECK(told_name("look.json") == "look.json");
    CHECK(told_name("/home/ann/looks/crt/beam.frag") == "beam.frag");
    CHECK(told_name({}).empty());
}

TEST_CASE("a folder in the user's home is shown with a tilde") {
    const std::string home = std::getenv("HOME");
    CHECK(told_folder(home + "/.local/share") == "~/.local/share");
    CHECK(told_folder(home + "x/a") == home + "x/a");
    CHECK(told_folder("/usr/share") == "/usr/share");
}
