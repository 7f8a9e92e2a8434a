#include "lab/storage/display_name.h"

#include <doctest/doctest.h>

#include <cstdlib>

TEST_CASE("a look's manifest is shown with its folder, and any other file by its name") {
    CHECK(display_name("/home/ann/looks/crt/look.json") == "crt/look.json");
    CHECK(display_name("look.json") == "look.json");
    CHECK(display_name("/home/ann/looks/crt/beam.frag") == "beam.frag");
    CHECK(display_name({}).empty());
}

TEST_CASE("a folder in the user's home is shown with a tilde") {
    const std::string home = std::getenv("HOME");
    CHECK(display_folder(home + "/.local/share") == "~/.local/share");
    CHECK(display_folder(home + "x/a") == home + "x/a");
    CHECK(display_folder("/usr/share") == "/usr/share");
}
