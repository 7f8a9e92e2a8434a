// Phosphor's beam: the position and reach of its spots, and the decay of their colours.
#include "looks/tube.h"

#include <doctest/doctest.h>

#include <numbers>

namespace {
/// The energy of the core or the glow, as documented in beam.frag.
double energy(double width_px, double weight, double sharpness) {
    return 0.7 * weight * width_px * width_px * std::numbers::pi / sharpness;
}

struct Position {
    double x = 0.0;
    double y = 0.0;
};

/// The centroid of a pass's light, in px from the left and the bottom.
Position middle_of(const Tube& tube, const char* pass) {
    const Picture light = tube.target(pass);
    double sum = 0.0;
    Position place;
    for (int y = 0; y < light.extent.height; ++y)
        for (int x = 0; x < light.extent.width; ++x) {
            const auto value = static_cast<double>(light.pixels[light.index(x, y) + 1]);
            sum += value;
            place.x += value * (x + 0.5);
            place.y += value * (light.extent.height - y - 0.5);
        }
    return {place.x / sum, place.y / sum};
}
}  // namespace

TEST_CASE("a wide spot is drawn up to its full reach, in a picture of any shape") {
    for (const Extent extent : {Extent{128, 128}, Extent{200, 128}}) {
        CAPTURE(extent.width);
        Tube tube({{"beam_width", Value(64.0)}, {"ceiling", Value(1000.0)}}, extent);
        tube.draw({{0.0f, 0.0f, 1.0f, 0.0f}});
        const double stated = energy(16.0, 1.0, 28.0) + energy(16.0, 0.3, 8.0);
        CHECK(std::abs(tube.sum("beam") / stated - 1.0) < 0.001);
    }
}

TEST_CASE("a spot centred outside the picture lights the part inside") {
    constexpr double beyond = 3.0;  // px
    Tube tube({{"beam_width", Value(32.0)}, {"ceiling", Value(1000.0)}}, {256, 256});
    tube.draw({{static_cast<float>(-1.0 - beyond * 2.0 / 256.0), 0.0f, 1.0f, 0.0f}});
    const auto inside = [](double sharpness) {
        return 0.5 * std::erfc(beyond * std::sqrt(sharpness) / 16.0);
    };
    const double stated =
        energy(16.0, 1.0, 28.0) * inside(28.0) + energy(16.0, 0.3, 8.0) * inside(8.0);
    CHECK(std::abs(tube.sum("beam") / stated - 1.0) < 0.002);
}

TEST_CASE("fit and size place the signal, as points and as segments") {
    Tube tube({}, {200, 100});
    const auto drawn_at = [&tube](double kind, double fit) {
        tube.restart({{"beam_kind", Value(kind)},
                      {"fit", Value(fit)},
                      {"screen_size", Value(0.8)},
                      {"ceiling", Value(1000.0)}});
        tube.draw({{0.5f, 0.25f, 1.0f, 0.0f}, {0.5f, 0.25f, 1.0f, 0.0f}});
        return middle_of(tube, kind == 0.0 ? "beam" : "segments");
    };
    for (const double kind : {0.0, 1.0}) {
        CAPTURE(kind);
        const Position filled = drawn_at(kind, 0.0);
        CHECK(std::abs(filled.x - (100.0 + 0.8 * 0.5 * 100.0)) < 0.01);
        CHECK(std::abs(filled.y - (50.0 + 0.8 * 0.25 * 50.0)) < 0.01);
        const Position round = drawn_at(kind, 1.0);  // both axes have the scale of the height
        CHECK(std::abs(round.x - (100.0 + 0.8 * 0.5 * 50.0)) < 0.01);
        CHECK(std::abs(round.y - (50.0 + 0.8 * 0.25 * 50.0)) < 0.01);
    }
}

TEST_CASE("each colour decays at its own rate, as points and as segments") {
    constexpr std::array<double, 3> speeds{0.5, 1.0, 4.0};
    Tube tube({}, {64, 64});
    for (const double kind : {0.0, 1.0}) {
        CAPTURE(kind);
        tube.restart({{"beam_kind", Value(kind)},
                      {"decay", Value(0.9)},
                      {"ceiling", Value(1000.0)},
                      {"beam_color", Value(std::vector<double>{1, 1, 1})},
                      {"fade_speed", Value(std::vector<double>(speeds.begin(), speeds.end()))}});
        constexpr float age = 0.25f / 60.0f;
        tube.draw({{0.0f, 0.0f, 1.0f, age}, {0.0f, 0.0f, 1.0f, age}});
        const double charge = tube.sum(kind == 0.0 ? "beam" : "segments", 1) / std::pow(0.9, 0.25);
        for (std::size_t i = 0; i < 3; ++i) {
            const double left = std::pow(0.9, 0.25 * speeds[i]);
            CHECK(std::abs(tube.sum("persistence", i) / charge - left) < 1e-3);
        }
        tube.rest(1);
        for (std::size_t i = 0; i < 3; ++i) {
            const double left = std::pow(0.9, 1.25 * speeds[i]);
            CHECK(std::abs(tube.sum("persistence", i) / charge - left) < 1e-3);
        }
    }
}

TEST_CASE("the segment from the previous frame's last point is drawn in this frame only") {
    Tube tube({{"beam_kind", Value(1.0)}, {"decay", Value(0.5)}, {"ceiling", Value(1000.0)}},
              {64, 64});
    tube.draw({{0.0f, 0.0f, 1.0f, 0.006f}});
    tube.draw({{0.0f, 0.0f, 1.0f, 0.0f}});
    // A charge of 1, uniform over the frame of 1/60 s.
    const double width = 2.0 * 64.0 / 512.0;
    const double charge = energy(width, 1.0, 28.0) + energy(width, 0.3, 8.0);
    const double left = (1.0 - 0.5) / -std::log(0.5);
    CHECK(std::abs(tube.sum("segments") / (charge * left) - 1.0) < 0.005);
}

TEST_CASE("the bloom ends at its outermost tap") {
    Tube tube({{"bloom_kind", Value(0.0)},
               {"bloom_radius", Value(8.0)},  // 4 texels of the half-size picture
               {"bloom_taps", Value(3.0)},
               {"bloom_sigma", Value(4.0)},
               {"beam_width", Value(0.5)},
               {"ceiling", Value(1000.0)}},
              {256, 256});
    const float px = 2.0f / 256.0f;
    tube.draw({{px, -px, 1e4f, 0.0f}});  // at the centre of a texel
    CHECK(tube.at("bloom_x", 64 + 4, 64) > 0.01 * tube.at("bloom_x", 64, 64));
    CHECK(tube.at("bloom_x", 64 + 6, 64) < 1e-6 * tube.at("bloom_x", 64, 64));
}
