#include "model/picture/beam_fit.h"

#include "about.h"

#include <doctest/doctest.h>

namespace {
Look look_with_fit(double initial) {
    Look look;
    look.passes.resize(1);
    Parameter fit;
    fit.name = "fit";
    fit.type = {Scalar::integer};
    fit.control = Control::list;
    fit.items = {{0, "Fill the picture"}, {1, "Keep circles round"}};
    fit.initial = Value(initial);
    look.parameters = {fit};
    return look;
}

constexpr Extent wide{400, 200};
constexpr Extent tall{100, 300};

// Half the size, in pixels, of -1..1 as a look draws it: filled, or with round circles.
std::array<double, 2> half_size(Extent picture, bool is_round) {
    const double shorter = std::min(picture.width, picture.height);
    return is_round ? std::array{shorter / 2.0, shorter / 2.0}
                    : std::array{picture.width / 2.0, picture.height / 2.0};
}

// The semi-axes, in pixels, of a circle of radius 1.
std::array<double, 2> circle(const Look& look, Extent picture, std::optional<Fit> fit) {
    const auto scale = beam_scale(look, {}, picture, fit);
    const auto drawn = half_size(picture, keeps_circles_round(look, {}, ""));
    return {scale[0] * drawn[0], scale[1] * drawn[1]};
}
}  // namespace

TEST_CASE("without a fit the beam keeps the look's own scale") {
    for (const double initial : {0.0, 1.0})
        CHECK(beam_scale(look_with_fit(initial), {}, wide, std::nullopt) == std::array{1.0, 1.0});
    CHECK(beam_scale({}, {}, wide, Fit::whole) == std::array{1.0, 1.0});  // a look without passes
}

TEST_CASE("whole and crop keep circles round for every look, and stretch fills the picture") {
    for (const double initial : {0.0, 1.0})
        for (const Extent picture : {wide, tall}) {
            CAPTURE(initial);
            const Look look = look_with_fit(initial);
            const double shorter = std::min(picture.width, picture.height) / 2.0;
            const double longer = std::max(picture.width, picture.height) / 2.0;
            const auto whole = circle(look, picture, Fit::whole);
            CHECK(whole[0] == about(shorter, 1e-9));
            CHECK(whole[1] == about(shorter, 1e-9));
            const auto crop = circle(look, picture, Fit::crop);
            CHECK(crop[0] == about(longer, 1e-9));
            CHECK(crop[1] == about(longer, 1e-9));
            const auto stretch = circle(look, picture, Fit::stretch);
            CHECK(stretch[0] == about(picture.width / 2.0, 1e-9));
            CHECK(stretch[1] == about(picture.height / 2.0, 1e-9));
        }
}
