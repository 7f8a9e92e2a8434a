// Phosphor driven by a source picture, compared with closed forms. The picture shines evenly during
// each frame.
#include "looks/measured_tubes.h"
#include "looks/tube.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>

namespace {
constexpr Extent small{8, 8};
constexpr double pixel_count = 64;
constexpr double near_enough = 0.001;

Picture filled(std::array<float, 3> rgb) {
    Picture picture;
    picture.extent = small;
    picture.encoding = Encoding::linear;
    for (int i = 0; i < small.width * small.height; ++i)
        picture.pixels.insert(picture.pixels.end(), {rgb[0], rgb[1], rgb[2], 1.0f});
    return picture;
}

const std::array<float, 3> white{1, 1, 1};
const std::array<float, 3> black{0, 0, 0};

/// White light far below the ceiling, of any tube.
Values white_light(double tube) {
    return {{"tube", Value(tube)},
            {"tube_color", Value(1.0)},
            {"beam_color", Value(std::vector<double>{1, 1, 1})},
            {"picture_gain", Value(0.5)}};
}

/// The part of the light of a flash that the phosphor has emitted after `frames` frames. The flash
/// shines evenly during the first one. By integrating each term's impulse response over the flash.
double emitted_part(const Decay& decay, double frame_seconds, int frames) {
    double sum = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const double e_folds = frame_seconds / decay.seconds[i];
        const double held_at_the_end = -std::expm1(-e_folds) / e_folds;
        sum += decay.weights[i] * decay.seconds[i] *
               (1 - held_at_the_end * std::exp(-(frames - 1) * e_folds));
    }
    return sum / decay.light();
}

double light(const Tube& tube, std::size_t channel = 1) {
    return tube.sum("persistence", channel) / pixel_count;
}
}  // namespace

TEST_CASE("a flash of a picture is emitted over time as the closed form of each measured tube") {
    Tube tube({}, small, Tube::By::picture);
    for (const MeasuredLine& line : measured) {
        CAPTURE(line.name);
        const Decay decay = solved(line);
        for (const double fps : {24.0, 60.0, 240.0}) {
            CAPTURE(fps);
            tube.restart(white_light(line.item));
            double emitted = 0;
            for (int frame = 1; frame <= 8; ++frame) {
                tube.show(filled(frame == 1 ? white : black));
                tube.draw({}, fps);
                emitted += light(tube);
                const double expected = 0.5 * emitted_part(decay, 1 / fps, frame);
                CHECK(std::abs(emitted / expected - 1) < near_enough);
            }
        }
    }
}

TEST_CASE("all the light of a flash of a picture is emitted in the end, at any decay time") {
    Tube tube({}, small, Tube::By::picture);
    for (const MeasuredLine& line : measured) {
        CAPTURE(line.name);
        for (const double scale : {0.1, 2.0}) {
            CAPTURE(scale);
            tube.restart(with(white_light(line.item), {{"time_scale", Value(scale)}}));
            tube.show(filled(white));
            tube.draw({}, 60);
            double emitted = light(tube);
            tube.show(filled(black));
            for (double length = 1.0 / 60; length < 4;
                 length *= 2) {  // 8 s in longer and longer frames
                tube.draw({}, 1 / length);
                emitted += light(tube) * length * 60;
            }
            CHECK(std::abs(emitted / 0.5 - 1) < near_enough);
        }
    }
}

TEST_CASE("a steady picture is as bright as its gain on every tube, at any frame rate") {
    Tube tube({}, small, Tube::By::picture);
    tube.show(filled(white));
    for (const MeasuredLine& line : measured) {
        CAPTURE(line.name);
        tube.restart(white_light(line.item));
        for (const double fps : {0.2, 24.0, 240.0}) {  // the first frame takes 5 s
            tube.draw({}, fps);
            if (fps > 1)
                CHECK(std::abs(light(tube) / 0.5 - 1) < near_enough);
        }
    }
}

TEST_CASE("a flash of a picture fades on the custom tube by its decay, and keeps its energy") {
    Tube tube({}, small, Tube::By::picture);
    for (const double decay : {0.5, 0.92, 0.99})
        for (const double fps : {24.0, 60.0, 240.0}) {
            CAPTURE(decay);
            CAPTURE(fps);
            tube.restart(with(white_light(0), {{"decay", Value(decay)}}));
            const double left = std::pow(decay, 60 / fps);  // per frame
            double sum = 0;
            for (int frame = 0; frame < 12; ++frame) {
                tube.show(filled(frame == 0 ? white : black));
                tube.draw({}, fps);
                sum += light(tube);
                const double expected = 0.5 * (1 - std::pow(left, frame + 1));
                CHECK(std::abs(sum / expected - 1) < near_enough);
            }
        }
}

TEST_CASE("a steady picture keeps its colours on the custom tube, at any decay") {
    Tube tube({}, small, Tube::By::picture);
    tube.show(filled({0.8f, 0.4f, 0.1f}));
    for (const double decay : {0.6, 0.95}) {
        tube.restart(with(white_light(0), {{"decay", Value(decay)},
                                           {"fade_speed", Value(std::vector<double>{2, 1, 4})}}));
        tube.rest(200);
        CHECK(std::abs(light(tube, 0) / 0.4 - 1) < near_enough);
        CHECK(std::abs(light(tube, 1) / 0.2 - 1) < near_enough);
        CHECK(std::abs(light(tube, 2) / 0.05 - 1) < near_enough);
    }
}

TEST_CASE("a monochrome phosphor shows the luminance of a picture by BT.709") {
    Tube tube({}, small, Tube::By::picture);
    const std::array<std::array<float, 3>, 3> primaries{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    const std::array<double, 3> luminances{0.2126, 0.7152, 0.0722};
    for (const double item : {0.0, 9.0})
        for (std::size_t i = 0; i < 3; ++i) {
            tube.restart(with(white_light(item), {{"one_color", Value(1.0)}}));
            tube.show(filled(primaries[i]));
            tube.draw({}, 0.1);
            CHECK(std::abs(light(tube, 0) / (0.5 * luminances[i]) - 1) < near_enough);
        }
}

TEST_CASE("the spot spreads the light of a pixel by its size and loses none") {
    constexpr int side = 64;
    Tube tube({}, {side, side}, Tube::By::picture);
    Picture dot;
    dot.extent = {side, side};
    dot.encoding = Encoding::linear;
    dot.pixels.assign(4 * side * side, 0.0f);
    const std::size_t middle = dot.index(side / 2, side / 2);
    for (std::size_t channel = 0; channel < 3; ++channel)
        dot.pixels[middle + channel] = 1.0f;
    tube.show(dot);
    for (const double size : {0.0, 8.0, 16.0}) {  // 0, 1 and 2 px of 64 lines
        CAPTURE(size);
        tube.restart(with(white_light(0), {{"spot_size", Value(size)}}));
        tube.draw({}, 0.1);
        CHECK(std::abs(tube.sum("picture") - 1) < near_enough);
        const Picture drawn = tube.target("picture");
        double variance = 0;
        for (int x = 0; x < side; ++x)
            for (int y = 0; y < side; ++y)
                variance += std::pow(x - side / 2, 2) *
                            static_cast<double>(drawn.pixels[drawn.index(x, y)]);
        CHECK(std::abs(std::sqrt(variance) - size / 8) < 0.05);
    }
}
