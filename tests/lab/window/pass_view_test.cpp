#include "lab/window/pass_view.h"

#include <doctest/doctest.h>

TEST_CASE("fitting shows every value of a pass, and resetting restores the defaults") {
    PassView view;
    view.exposure = 3.0;
    view.channels = Channels::green;
    view.fit({.minimum = -1.0, .maximum = 7.0, .finite = 2});
    CHECK(view.levels == Levels{-1, 7});
    CHECK(view.exposure == 0.0);
    CHECK(view.has_levels());
    view.reset_levels();
    CHECK_FALSE(view.has_levels());
    CHECK(view.channels == Channels::green);
}

TEST_CASE("inspecting another pass shows its current picture") {
    PassView view;
    view.inspect({Input::From::pass, "persistence", 1});
    CHECK(view.pass == "persistence");
    CHECK(view.label() == "persistence@1");
    view.inspect({Input::From::image, "noise", 0, 2});
    CHECK(view.pass == "persistence");
    CHECK(view.label() == "noise mip 2");
    view.inspect("beam");
    CHECK(view.label() == "beam");
    view.inspect({Input::From::pass, "glass"});
    CHECK_FALSE(view.other.has_value());
}
