// Phosphor's measured tubes compared with the Tektronix decay table and closed forms.
#include "looks/measured_tubes.h"
#include "looks/tube.h"
#include "model/look/color.h"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <array>
#include <numeric>

namespace {
constexpr const MeasuredLine& p7 = measured[4];
constexpr const MeasuredLine& p31 = measured[8];
constexpr const MeasuredLine& p32 = measured[9];

constexpr std::array<int, 5> rates{24, 30, 60, 144, 240};
constexpr Extent small{16, 16};

/// White light, far below the ceiling.
Values white(const MeasuredLine& tube) {
    return {{"tube", Value(tube.item)},
            {"tube_color", Value(1.0)},
            {"beam_color", Value(std::vector<double>{1, 1, 1})},
            {"beam_gain", Value(0.001)}};
}

Beam flash(double age) {
    return {{0.0f, 0.0f, 1.0f, static_cast<float>(age)}};
}

/// Light per second at one instant, some time after a flash.
double brightness_after(Tube& tube, const Values& values, double seconds) {
    constexpr double instant = 1e-7;
    tube.restart(values);
    if (seconds > 0)
        tube.draw(flash(seconds), 1 / seconds);
    tube.draw(seconds > 0 ? Beam{} : flash(instant), 1 / instant);
    return tube.sum("persistence");
}

double luminance(const std::array<double, 3>& rgb) {
    return 0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2];
}

std::array<double, 3> light_of(const Tube& tube) {
    return {tube.sum("persistence", 0), tube.sum("persistence", 1), tube.sum("persistence", 2)};
}

std::array<double, 3> scaled_to_1(std::array<double, 3> rgb) {
    const double maximum = *std::max_element(rgb.begin(), rgb.end());
    for (double& channel : rgb)
        channel /= maximum;
    return rgb;
}
}  // namespace

TEST_CASE("every tube is at 10, 1 and 0.1 % at the measured times") {
    Tube tube({}, small);
    for (const MeasuredLine& line : measured) {
        CAPTURE(line.name);
        const double full = brightness_after(tube, white(line), 0);
        for (std::size_t i = 0; i < 3; ++i) {
            const double expected = std::pow(0.1, static_cast<double>(i + 1));
            const double left =
                brightness_after(tube, white(line), 0.001 * line.milliseconds[i]) / full;
            CHECK(std::abs(left / expected - 1) < 0.001);
        }
    }
}

TEST_CASE("the time scale stretches a tube's decay") {
    Tube tube({}, small);
    for (const double scale : {0.05, 100.0}) {
        const Values values = with(white(p31), {{"time_scale", Value(scale)}});
        const double left =
            brightness_after(tube, values, scale * 0.0045) / brightness_after(tube, values, 0);
        CHECK(std::abs(left / 0.01 - 1) < 0.01);
    }
}

TEST_CASE("after a flash each frame shows the light emitted during it, at every frame rate") {
    Tube tube({}, small);
    for (const MeasuredLine& line : measured) {
        const Decay decay = solved(line);
        for (const int fps : rates) {
            CAPTURE(line.name);
            CAPTURE(fps);
            tube.restart(white(line));
            double peak = 0;
            double apart = 0;
            double scale = 0;
            for (int k = 1; k <= 60; ++k) {
                tube.draw(k == 1 ? flash(1.0 / fps) : Beam{}, fps);
                if (k == 1)  // a charge of 1 gives the total light of brightness 12 during 1/60 s
                    scale = tube.sum("beam", 3) * 12 / 60 / decay.light();
                const double expected =
                    (decay.light_until(k * 1.0 / fps) - decay.light_until((k - 1) * 1.0 / fps)) *
                    fps;
                peak = std::max(peak, expected);
                apart = std::max(apart, std::abs(tube.sum("persistence") / scale - expected));
            }
            CHECK(apart < 0.0002 * peak);
        }
    }
}

TEST_CASE("the light of two seconds is the same at every frame rate") {
    Tube tube({}, small);
    for (const MeasuredLine& line : measured) {
        const Decay decay = solved(line);
        for (const int fps : rates) {
            CAPTURE(line.name);
            CAPTURE(fps);
            tube.restart(white(line));
            double light = 0;
            double charge = 0;
            for (int k = 1; k <= 2 * fps; ++k) {
                tube.draw(k == 1 ? flash(1.0 / fps) : Beam{}, fps);
                charge += k == 1 ? tube.sum("beam", 3) : 0.0;
                light += tube.sum("persistence") / fps;
            }
            const double expected = charge * 12 / 60 * decay.light_until(2) / decay.light();
            CHECK(std::abs(light / expected - 1) < 0.0001);
        }
    }
}

TEST_CASE("a static trace has the same brightness at every frame rate") {
    constexpr int points = 24;
    Tube tube({}, small);
    for (const int fps : rates) {
        CAPTURE(fps);
        Beam beam;
        for (int i = 0; i < points; ++i)
            beam.push_back({0.0f, 0.0f, 60.0f / static_cast<float>(fps) / points,
                            (static_cast<float>(i) + 0.5f) / points / static_cast<float>(fps)});
        tube.restart(white(p32));
        for (int k = 1; k <= 2 * fps; ++k)
            tube.draw(beam, fps);
        const double charge_per_second = tube.sum("beam", 3) * fps;
        CHECK(std::abs(tube.sum("persistence") / (charge_per_second * 12 / 60) - 1) < 0.001);
    }
}

TEST_CASE("a tube's light has its colour, and its luminance relative to P31") {
    // Linear sRGB of the emission chromaticities, mixed with neutral if out of gamut; the largest
    // is 1.
    const std::vector<std::pair<double, std::array<double, 3>>> published{
        {1, {0, 1, 0.235}}, {3, {1, 0.42, 0}},  {4, {0.488, 0.781, 1}},
        {6, {0, 0.353, 1}}, {9, {0, 1, 0.373}},
    };
    Tube tube({}, small);
    const auto flashed = [&](double item) {
        tube.restart({{"tube", Value(item)}, {"beam_gain", Value(0.001)}});
        tube.draw(flash(2.0), 0.5);  // a frame of 2 s contains all light
        return light_of(tube);
    };
    for (const auto& line : published) {
        CAPTURE(line.first);
        const auto shown = scaled_to_1(flashed(line.first));
        for (std::size_t i = 0; i < 3; ++i)
            CHECK(std::abs(shown[i] - line.second[i]) < 0.002);
    }
    const double reference = luminance(flashed(p31.item));
    for (const MeasuredLine& line : measured) {
        CAPTURE(line.name);
        CHECK(std::abs(luminance(flashed(line.item)) / reference - line.luminance / 100) < 0.002);
    }
}

TEST_CASE("P7 flashes blue with a yellow-green afterglow, and P14 with an orange one") {
    Tube tube({}, small);
    const auto after = [&](double item, double seconds) {
        tube.restart({{"tube", Value(item)}, {"beam_gain", Value(0.001)}});
        if (seconds > 0)
            tube.draw(flash(seconds), 1 / seconds);
        tube.draw(seconds > 0 ? Beam{} : flash(1e-6), 1e6);
        return scaled_to_1(light_of(tube));
    };
    CHECK(after(5, 0)[2] == 1.0);
    CHECK(after(5, 0)[1] < 0.01);
    constexpr std::array<double, 3> yellow_green{0.418, 1, 0.034};
    for (std::size_t i = 0; i < 3; ++i)
        CHECK(std::abs(after(5, 0.02)[i] - yellow_green[i]) < 0.002);
    CHECK(after(7, 0)[2] == 1.0);
    CHECK(after(7, 0.02)[0] == 1.0);
    CHECK(after(7, 0.02)[2] < 0.01);
}

TEST_CASE("the tail gain scales the afterglow and keeps the flash") {
    const Decay decay = solved(p31);
    Tube tube({}, small);
    for (const double gain : {0.0, 1.0, 4.0}) {
        CAPTURE(gain);
        tube.restart(with(white(p31), {{"tail_gain", Value(gain)}}));
        tube.draw(flash(2.0), 0.5);
        const double first = decay.weights[0] * decay.seconds[0];
        const double expected = (first + gain * (decay.light() - first)) / decay.light();
        const double light = tube.sum("persistence") * 2 / (tube.sum("beam", 3) * 12 / 60);
        CHECK(std::abs(light - expected) < 0.002);
    }
}

TEST_CASE("an overdriven tube has the brightness of its ceiling and decays from there") {
    Tube tube(with(white(p32), {{"ceiling", Value(2.5)}, {"beam_gain", Value(0.7)}}), {64, 64});
    tube.draw(tube.flood());
    tube.rest(1);
    CHECK(std::abs(tube.at("persistence", 32, 32) - 2.5) < 1e-4);
    tube.rest(60);  // a second later only the slowest term is left
    CHECK(std::abs(tube.at("persistence", 32, 32) / (2.5 * std::exp(-1 / 0.1175)) - 1) < 0.001);
}

TEST_CASE("in a short frame the ceiling is higher in proportion to the shorter time") {
    const Values values = with(white(p32), {{"ceiling", Value(2.5)}, {"beam_gain", Value(0.7)}});
    Tube tube(values, {64, 64});
    Beam early = tube.flood();  // so that much of its light is emitted within the frame
    for (BeamPoint& point : early)
        point.age_seconds = 0.004f;
    tube.draw(early, 240.0);
    CHECK(std::abs(tube.at("persistence", 32, 32) - 4 * 2.5) < 1e-3);
    tube.restart(values);
    tube.draw(early, 24.0);
    CHECK(std::abs(tube.at("persistence", 32, 32) - 2.5) < 1e-4);
}

TEST_CASE("a tube's flash and afterglow use the chosen colours") {
    const Value beam(std::vector<double>{1, 0.5, 0.25});
    const Value after(std::vector<double>{0.2, 0.4, 1});
    Tube tube({}, small);
    const auto shown = [&](double choice, double seconds) {
        tube.restart({{"tube", Value(p7.item)},
                      {"tube_color", Value(choice)},
                      {"beam_color", beam},
                      {"afterglow_color", after},
                      {"beam_gain", Value(0.001)}});
        if (seconds > 0)
            tube.draw(flash(seconds), 1 / seconds);
        tube.draw(seconds > 0 ? Beam{} : flash(1e-6), 1e6);
        return scaled_to_1(light_of(tube));
    };
    for (std::size_t i = 0; i < 3; ++i) {
        CHECK(std::abs(shown(1, 0)[i] - beam.numbers[i]) < 0.002);
        CHECK(std::abs(shown(1, 0.02)[i] - beam.numbers[i]) < 0.002);
        CHECK(std::abs(shown(2, 0)[i] - beam.numbers[i]) < 0.05);  // includes a little afterglow
        CHECK(std::abs(shown(2, 0.02)[i] - after.numbers[i]) < 0.002);
    }
}

TEST_CASE("the custom tube stores no charges, and the article has no tubes") {
    Tube custom({}, small);
    custom.draw(flash(0));
    CHECK(custom.target("excitation").extent == Extent{1, 1});
    Tube article({{"as_written", Value(1.0)}}, small);
    article.draw(flash(0));
    const double light = article.sum("persistence");
    article.restart({{"as_written", Value(1.0)}, {"tube", Value(9.0)}});
    article.draw(flash(0));
    CHECK(light > 0.001);
    CHECK(article.sum("persistence") == light);
}

TEST_CASE("the list of tubes shows the measured time to 10 % and the colour of the flash") {
    Tube tube({}, small);
    const Parameter& list = *find_parameter(tube.look(), "tube");
    REQUIRE(list.items.size() == measured.size() + 1);
    CHECK(list.items[0].note.empty());
    CHECK_FALSE(list.items[0].color.has_value());
    for (const MeasuredLine& line : measured) {
        CAPTURE(line.name);
        const Item& item = list.items[static_cast<std::size_t>(line.item)];
        CHECK(item.label == line.name);
        CHECK(item.note == fmt::format("{:g} ms", line.milliseconds[0]));
        tube.restart(
            {{"tube", Value(line.item)}, {"tail_gain", Value(0.0)}, {"beam_gain", Value(0.001)}});
        tube.draw(flash(1.0 / 60.0), 60.0);
        const auto light = scaled_to_1(light_of(tube));
        REQUIRE(item.color.has_value());
        for (std::size_t i = 0; i < 3; ++i)
            CHECK(std::abs(srgb_encode((*item.color)[i]) - srgb_encode(light[i])) < 0.6 / 255.0);
    }
}
