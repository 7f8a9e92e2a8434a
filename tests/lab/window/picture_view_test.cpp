#include "lab/window/picture_view.h"

#include <doctest/doctest.h>

#include <cmath>

TEST_CASE("a picture is shown at a whole-number zoom, or completely if larger than its view") {
    const PictureView view;
    CHECK(view.zoom_for({480, 270}, {1000, 600}) == 2.0);
    CHECK(view.zoom_for({480, 270}, {480, 270}) == 1.0);
    CHECK(view.zoom_for({480, 270}, {500, 300}) == 1.0);
    CHECK(view.zoom_for({480, 270}, {300, 400}) == 300.0 / 480.0);
    CHECK(view.zoom_for({2000, 1000}, {1000, 500}) == 0.5);  // twice the view's size
    const PicturePosition place = position_of(view, {480, 270}, {240, 400});
    CHECK(place.left == 0.0);
    CHECK(place.top == (400 - 135) / 2.0 + 0.5);  // on a whole screen pixel
}

TEST_CASE("zooming keeps the point under the pointer in place") {
    const Extent picture{400, 200};
    const Extent room{200, 100};
    PictureView view{PictureView::Fit::free, 2.0, 0.5, 0.5};
    const std::array<double, 2> pointer{50.0, 25.0};
    const auto before = position_of(view, picture, room).pixel_at(pointer[0], pointer[1]);
    view.zoom_about(before[0] / picture.width, before[1] / picture.height, 2.0, 4.0);
    const auto after = position_of(view, picture, room).pixel_at(pointer[0], pointer[1]);
    CHECK(std::abs(after[0] - before[0]) <= 0.5 / 4.0);  // places are whole screen pixels
    CHECK(std::abs(after[1] - before[1]) <= 0.5 / 4.0);
    CHECK(view.zoom == 4.0);
}
