// The templates of new looks, compared with closed forms.
#include "lab/library/look_templates.h"
#include "looks/drawn_look.h"
#include "looks/drawn_picture.h"

#include <algorithm>
#include <cmath>

namespace {
constexpr Extent square{128, 128};
constexpr double unit = 128.0 / 512.0;  // px of the picture per px at 512 lines

// sRGB, IEC 61966-2-1.
double encoded(double linear) {
    return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055;
}

// K. Narkowicz's fit of the ACES curve.
double aces(double light) {
    return light * (2.51 * light + 0.03) / (light * (2.43 * light + 0.59) + 0.14);
}
}  // namespace

TEST_CASE("templates load without warnings, and each kind of driver has one") {
    const std::filesystem::path root(AFTERGLOW_SOURCE_DIR);
    const auto templates = look_templates(root);
    REQUIRE(templates.size() == 3);
    std::vector<Driver> drivers;
    for (const LookTemplate& look : templates) {
        const LoadedLook loaded = load_look(look.folder, root / "shaders" / "include");
        REQUIRE_MESSAGE(loaded.look.has_value(), problems_of(loaded.look));
        CHECK_MESSAGE(loaded.warnings.empty(), to_string(loaded.warnings));
        CHECK(loaded.look->parameters.size() >= 6);
        drivers.push_back(loaded.look->driven_by);
    }
    CHECK(drivers == std::vector{Driver::picture, Driver::signal, Driver::nothing});
}

TEST_CASE("filter template: a flat field has the sum of the scanlines' Gaussians") {
    const Picture white = flat_field({64, 64}, 1.0f, 1.0f, 1.0f);
    const Picture drawn = drawn_look("templates/filter", white,
                                     {{"stripe_depth", Value(0.0)},
                                      {"glow_amount", Value(0.0)},
                                      {"exposure", Value(1.0)},
                                      {"beam_width", Value(0.5)},
                                      {"beam_growth", Value(0.5)}});
    // One line per pixel; the full width at half maximum is 0.5 * (1 + 0.5) lines.
    const double sigma = 0.75 / (2.0 * std::sqrt(2.0 * std::log(2.0)));
    const double variance = sigma * sigma + 1.0 / 12.0;
    double light = 0.0;
    for (int line = -2; line <= 2; ++line)
        light += std::exp(-0.5 * line * line / variance) / std::sqrt(2.0 * M_PI * variance);
    CHECK(std::abs(mean_of(drawn, 1, 16, 16, {32, 32}) - encoded(aces(light))) < 0.002);
    const Picture black = flat_field({64, 64}, 0.0f, 0.0f, 0.0f);
    CHECK(mean_of(drawn_look("templates/filter", black, {}), 1, 0, 0, {64, 64}) == 0.0);
}

TEST_CASE("beam template: each layer gets the beam's charge and keeps its part of it") {
    DrawnLook look("shaders/templates/beam", square,
                   {{"flash_decay", Value(0.5)}, {"afterglow_decay", Value(0.9)}});
    for (const int fps : {30, 60}) {
        CAPTURE(fps);
        look.restart();
        look.draw({{-0.2f, 0.0f, 3.0f, 0.0f}, {0.2f, 0.1f, 3.0f, 0.0f}}, fps);
        const double charge = 3.0 * unit * unit;
        CHECK(std::abs(sum_of(look.target("persistence"), 0) / charge - 1.0) < 0.002);
        CHECK(std::abs(sum_of(look.target("persistence"), 1) / charge - 1.0) < 0.002);
        for (int i = 0; i < fps / 10; ++i)  // 0.1 s, which is 6/60 s
            look.draw({}, fps);
        const Picture later = look.target("persistence");
        CHECK(std::abs(sum_of(later, 0) / charge / std::pow(0.5, 6) - 1.0) < 0.002);
        CHECK(std::abs(sum_of(later, 1) / charge / std::pow(0.9, 6) - 1.0) < 0.002);
    }
}

TEST_CASE("generator template: it repeats after 60 turns and is dark outside the rim") {
    const Picture source = flat_field({96, 96}, 0.0f, 0.0f, 0.0f);
    const Values values{{"turn_seconds", Value(0.1)}, {"clutter", Value(0.0)}};
    const Picture one = drawn_look_at("templates/generator", {96, 96}, source, values, 30);
    const Picture later = drawn_look_at("templates/generator", {96, 96}, source, values, 390);
    double largest = 0.0;
    for (std::size_t i = 0; i < one.pixels.size(); ++i)
        largest = std::max(largest, std::abs(static_cast<double>(one.pixels[i] - later.pixels[i])));
    CHECK(largest < 0.02);
    CHECK(value_at(one, 1, 1, 1) == 0.0);
    CHECK(mean_of(one, 1, 24, 24, {48, 48}) > 0.05);
}
