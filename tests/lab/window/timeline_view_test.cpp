#include "lab/window/timeline_view.h"

#include <doctest/doctest.h>

TEST_CASE("a timeline shows all until it is zoomed, and the time under the pointer stays") {
    TimelineView view;
    CHECK(view.visible(100.0) == TimelineRange{0.0, 100.0});
    view.zoom(100.0, 4.0, 0.5);
    CHECK(view.visible(100.0) == TimelineRange{37.5, 62.5});
    view.zoom(100.0, 2.5, 0.0);
    CHECK(view.visible(100.0).start == doctest::Approx(37.5));
    CHECK(view.visible(100.0).end == doctest::Approx(47.5));
    view.zoom(100.0, 1e-9, 0.3);
    CHECK_FALSE(view.is_zoomed());
}

TEST_CASE("zoom and pan stay within the sound") {
    TimelineView view;
    view.zoom(100.0, 10.0, 0.0);
    view.pan(100.0, -5.0);
    CHECK(view.visible(100.0) == TimelineRange{0.0, 10.0});
    view.pan(100.0, 100.0);
    CHECK(view.visible(100.0) == TimelineRange{90.0, 100.0});
    view.zoom(100.0, 1e12, 1.0);
    CHECK(view.visible(100.0).seconds() == doctest::Approx(0.01));
    CHECK(view.visible(5.0).end <= 5.0);  // a shorter sound
}

TEST_CASE("the page turns when the position leaves it, but not during a drag") {
    TimelineView view;
    view.zoom(100.0, 10.0, 0.0);
    view.follow(100.0, 9.9);
    CHECK(view.visible(100.0).start == 0.0);
    view.drag = TimelineDrag{};
    view.follow(100.0, 10.5);
    CHECK(view.visible(100.0).start == 0.0);
    view.drag.reset();
    view.follow(100.0, 10.5);
    CHECK(view.visible(100.0) == TimelineRange{10.5, 20.5});
}

TEST_CASE("labels of the time axis are round and fit") {
    CHECK(label_step(60.0, 6.0) == 10.0);
    CHECK(label_step(200.0, 5.0) == 60.0);
    CHECK(label_step(0.03, 10.0) == 0.005);
    CHECK(label_step(1e9, 1.0) == 3600.0);
}
