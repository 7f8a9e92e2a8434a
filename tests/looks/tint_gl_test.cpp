// A beam with its own colours, in the looks that draw a beam.
#include "looks/drawn_look.h"

#include <algorithm>
#include <cmath>

namespace {
constexpr Extent square{64, 64};
const Values white{{"beam_color", Value(std::vector<double>{1.0, 1.0, 1.0})}};

Values white_and(const Values& more) {
    Values values = white;
    for (const auto& [name, value] : more)
        values[name] = value;
    return values;
}

/// A horizontal line in 16 steps of a frame, in one colour.
Beam line(float y, const BeamTint& tint) {
    Beam beam;
    for (int i = 0; i <= 16; ++i)
        beam.push_back({static_cast<float>(i) / 16.0f - 0.5f, y, 20.0f,
                        static_cast<float>(16 - i) / 16.0f / 60.0f});
    beam.tints.assign(beam.size(), tint);
    return beam;
}

Beam without_tints(Beam beam) {
    beam.tints.clear();
    return beam;
}

float largest(const Picture& picture, std::size_t channel) {
    float maximum = 0.0f;
    for (std::size_t i = channel; i < picture.pixels.size(); i += 4)
        maximum = std::max(maximum, picture.pixels[i]);
    return maximum;
}

std::vector<float> rgb(const Picture& picture) {
    std::vector<float> values;
    for (std::size_t i = 0; i < picture.pixels.size(); ++i)
        if (i % 4 != 3)
            values.push_back(picture.pixels[i]);
    return values;
}

struct TintedDrawing {
    const char* look;
    const char* light;    // the pass with the glowing light, in colour
    const char* picture;  // the last one
    Values values;
};

const std::vector<TintedDrawing> drawings{
    {"shaders/phosphor", "persistence", "composite", white},
    {"shaders/phosphor", "persistence", "composite", white_and({{"beam_kind", Value(1.0)}})},
    {"shaders/phosphor", "persistence", "composite", white_and({{"as_written", Value(1.0)}})},
    {"shaders/vector-beam", "light", "screen", white},
    {"shaders/vector-beam", "light", "screen", white_and({{"as_written", Value(1.0)}})},
};
}  // namespace

TEST_CASE("a red beam leaves no green or blue, and as much red as a white beam") {
    for (const TintedDrawing& drawing : drawings) {
        CAPTURE(drawing.look);
        DrawnLook look(drawing.look, square, drawing.values);
        look.draw(line(0.0f, {}));
        const double white_light = sum_of(look.target(drawing.light));
        look.restart();
        look.draw(line(0.0f, {1.0f, 0.0f, 0.0f}));
        look.draw(line(0.2f, {1.0f, 0.0f, 0.0f}));
        CHECK(largest(look.target(drawing.light), 1) == 0.0f);
        CHECK(largest(look.target(drawing.light), 2) == 0.0f);
        look.restart();
        look.draw(line(0.0f, {1.0f, 0.0f, 0.0f}));
        CHECK(std::abs(sum_of(look.target(drawing.light)) / white_light - 1.0) < 1e-5);
    }
}

TEST_CASE("the glow of a red beam is red") {
    DrawnLook look("shaders/vector-beam", square,
                   white_and({{"glow_amount", Value(2.0)},
                              {"tone_map", Value(0.0)},
                              {"background", Value(std::vector<double>(3, 0.0))},
                              {"dither", Value(0.0)}}));
    look.draw(line(0.0f, {1.0f, 0.0f, 0.0f}));
    const Picture picture = look.target("screen");
    CHECK(largest(picture, 0) > 0.3f);
    CHECK(largest(picture, 1) == 0.0f);
    CHECK(largest(picture, 2) == 0.0f);
}

TEST_CASE("the components of a tint scale the light") {
    for (const TintedDrawing& drawing : drawings) {
        CAPTURE(drawing.look);
        DrawnLook look(drawing.look, square, drawing.values);
        look.draw(line(0.0f, {}));
        const Picture lit = look.target(drawing.light);
        look.restart();
        look.draw(line(0.0f, {0.25f, 1.0f, 0.5f}));
        const Picture colored = look.target(drawing.light);
        const double factors[] = {0.25, 1.0, 0.5};
        for (std::size_t channel = 0; channel < 3; ++channel)
            CHECK(std::abs(sum_of(colored, channel) / sum_of(lit, channel) - factors[channel]) <
                  1e-4);
    }
}

TEST_CASE("a white tint gives exactly the picture of a beam without tints") {
    for (const TintedDrawing& drawing : drawings) {
        CAPTURE(drawing.look);
        DrawnLook look(drawing.look, square, drawing.values);
        look.draw(without_tints(line(0.0f, {})));
        look.draw(without_tints(line(0.2f, {})));
        const Picture plain = look.target(drawing.picture);
        look.restart();
        look.draw(line(0.0f, {}));
        look.draw(line(0.2f, {}));
        CHECK(rgb(look.target(drawing.picture)) == rgb(plain));
    }
}

TEST_CASE(
    "a measured tube glows in its own colour, scaled by the strongest component of the tint") {
    DrawnLook look("shaders/phosphor", square, {{"tube", Value(9.0)}});
    look.draw(without_tints(line(0.0f, {})));
    const double white_beam = sum_of(look.target("persistence"), 1);
    look.restart();
    look.draw(line(0.0f, {0.5f, 0.125f, 0.0f}));
    CHECK(std::abs(sum_of(look.target("persistence"), 1) / white_beam - 0.5) < 1e-4);
}
