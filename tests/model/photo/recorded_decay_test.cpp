// Decays in videos of an independent camera: the light of each frame is the integral of the
// exponentials, with noise, gamma and 8 bits.
#include "model/photo/decay_likelihood.h"
#include "model/photo/light_curve.h"
#include "model/photo/time_constants.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <string>

namespace {
constexpr double fps = 240.0;
constexpr int steps = 4;

// Tektronix, "CRT Data", 1966, as in shaders/include/tubes.glsl: milliseconds and weights.
struct Tube {
    const char* name;
    std::array<double, 3> milliseconds;
    std::array<double, 3> weights;
    glm::dvec3 flash;
    glm::dvec3 afterglow;
};
const std::array<Tube, 10> tubes{{
    {"P1",
     {7.7972, 15.3399, 1.0},
     {0.511968, 0.488032, 0.0},
     {0.0, 0.6146, 0.1442},
     {0.0, 0.6146, 0.1442}},
    {"P2",
     {0.139829, 2.35, 25.5},
     {0.964128, 0.0284827, 0.00738906},
     {0.0, 0.8262, 0.1260},
     {0.0, 0.8262, 0.1260}},
    {"P3",
     {5.80308, 12.7447, 1.0},
     {0.66825, 0.33175, 0.0},
     {0.8777, 0.3683, 0.0},
     {0.8777, 0.3683, 0.0}},
    {"P4",
     {0.118468, 1.65, 10.0},
     {0.957966, 0.0346461, 0.00738766},
     {0.3323, 0.5316, 0.6807},
     {0.3323, 0.5316, 0.6807}},
    {"P7",
     {0.114717, 2.85, 33.0},
     {0.964657, 0.0279535, 0.00738906},
     {0.4543, 0.0, 4.8950},
     {0.2334, 0.5579, 0.0187}},
    {"P11",
     {0.102132, 1.3, 8.5},
     {0.958928, 0.0336833, 0.00738854},
     {0.0, 0.2718, 0.7698},
     {0.0, 0.2718, 0.7698}},
    {"P14",
     {0.163745, 3.35, 27.5},
     {0.961513, 0.0310981, 0.00738904},
     {0.0, 0.2979, 2.5891},
     {0.8299, 0.3126, 0.0}},
    {"P28",
     {0.142649, 8.5, 66.25},
     {0.960961, 0.0316496, 0.00738902},
     {0.3000, 0.6094, 0.0052},
     {0.3000, 0.6094, 0.0052}},
    {"P31",
     {0.12604, 2.25, 16.0},
     {0.959932, 0.0326786, 0.0073889},
     {0.0, 1.3475, 0.5025},
     {0.0, 1.3475, 0.5025}},
    {"P32",
     {0.377885, 9.0, 117.5},
     {0.965564, 0.0270472, 0.00738906},
     {0.1155, 0.3119, 0.0326},
     {0.1155, 0.3119, 0.0326}},
}};

// The light from `from` to `to` seconds after a flash of no length.
glm::dvec3 light_between(const Tube& tube, double from, double to) {
    glm::dvec3 light(0.0);
    for (std::size_t i = 0; i < 3; ++i) {
        const double seconds = 0.001 * tube.milliseconds[i];
        const double amount =
            tube.weights[i] * seconds *
            (std::exp(-std::max(from, 0.0) / seconds) - std::exp(-std::max(to, 0.0) / seconds));
        light += amount * (i == 0 ? tube.flash : tube.afterglow);
    }
    return light;
}

// A video of a flash, `phase` of a frame before the end of frame 10. Display values, 8 bits, the
// mean of 64 pixels.
PixelLight video_of(const Tube& tube, double phase, unsigned seed) {
    constexpr double frame = 1.0 / fps;
    constexpr int frames = 160;
    constexpr double gamma = 2.2;
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    const glm::dmat3 colours(glm::dvec3(1.2, 0.08, 0.02), glm::dvec3(0.06, 1.0, 0.07),
                             glm::dvec3(0.01, 0.09, 0.7));
    const double flash = (11.0 - phase) * frame;
    std::vector<glm::dvec3> light;
    double most = 0.0;
    for (int i = 0; i < frames; ++i) {
        light.push_back(colours * light_between(tube, i * frame - flash, (i + 1) * frame - flash));
        most = std::max({most, light.back().r, light.back().g, light.back().b});
    }
    PixelLight pixels;
    std::vector<glm::dvec3> before(64, glm::dvec3(0.0));
    for (const glm::dvec3& seen : light) {
        glm::dvec3 sum(0.0);
        glm::dvec3 change(0.0);
        for (std::size_t pixel = 0; pixel < 64; ++pixel)
            for (glm::length_t c = 0; c < 3; ++c) {
                const double exposed = 0.8 * seen[c] / most + 0.001;
                const double noisy = exposed + normal(random) * std::sqrt(2e-5 + 2e-4 * exposed);
                const double value = std::pow(std::clamp(noisy, 0.0, 1.0), 1.0 / gamma);
                const double shown = std::pow(std::round(255.0 * value) / 255.0, gamma);
                sum[c] += shown / 64.0;
                change[c] += std::pow(shown - before[pixel][c], 2) / 64.0;
                before[pixel][c] = shown;
            }
        pixels.mean.push_back(sum);
        pixels.deviation.push_back(glm::sqrt(change));
    }
    return pixels;
}

std::vector<glm::dvec3> response_of(const Tube& tube) {
    std::vector<glm::dvec3> light;
    constexpr double step = 1.0 / (fps * steps);
    for (int i = 0; i < 700; ++i)
        light.push_back(light_between(tube, i * step, (i + 1) * step));
    return light;
}
}  // namespace

TEST_CASE("the tube of a recorded decay is the most likely of ten") {
    int right = 0;
    for (const Tube& tube : tubes)
        for (const unsigned seed : {1U, 2U}) {
            const auto recorded =
                recorded_decay(light_curve(video_of(tube, 0.3 * seed, seed), fps, 2.2));
            REQUIRE(recorded);
            double best = -std::numeric_limits<double>::infinity();
            std::string name;
            for (const Tube& other : tubes)
                if (const auto found = decay_likelihood(*recorded, response_of(other), steps);
                    found.logarithm > best) {
                    best = found.logarithm;
                    name = other.name;
                }
            right += name == tube.name ? 1 : 0;
        }
    CHECK(right >= 18);  // of 20
}

TEST_CASE("a time constant longer than a frame is found within 5 %") {
    std::vector<double> errors;
    double covered = 0.0;
    for (const Tube& tube : tubes)
        for (const unsigned seed : {1U, 2U, 3U}) {
            CAPTURE(tube.name);
            const auto recorded =
                recorded_decay(light_curve(video_of(tube, 0.3 * seed, seed), fps, 2.2));
            REQUIRE(recorded);
            const double slowest = 0.001 * std::ranges::max(tube.milliseconds);
            const std::vector<TimeConstant> constants = time_constants(*recorded);
            REQUIRE(!constants.empty());
            errors.push_back(std::abs(constants.back().seconds / slowest - 1.0));
            covered +=
                constants.back().low <= slowest && slowest <= constants.back().high ? 1.0 : 0.0;
            for (const TimeConstant& constant : constants) {
                CHECK(constant.low <= constant.seconds);
                CHECK(constant.seconds <= constant.high);
                if (constant.seconds < 1.0 / fps)
                    CHECK(constant.why_not == "it is shorter than a frame of the video");
            }
        }
    std::ranges::sort(errors);
    CHECK(errors[errors.size() / 2] < 0.05);
    CHECK(errors[errors.size() * 9 / 10] < 0.12);
    CHECK(covered / static_cast<double>(errors.size()) >= 0.85);
}

TEST_CASE("light that was on for several frames fades from the first dark frame") {
    // 8 lit frames, then a fall by half each frame.
    PixelLight pixels;
    for (int i = 0; i < 30; ++i) {
        const double light = i < 3 ? 0.0 : i < 11 ? 0.8 : 0.8 * std::exp2(10.0 - i);
        pixels.mean.emplace_back(light);
        pixels.deviation.emplace_back(0.0);
    }
    const auto recorded = recorded_decay(light_curve(pixels, fps, 2.2));
    REQUIRE(recorded);
    CHECK(recorded->lit_frames == 8);
    CHECK(recorded->curve.light.size() == 18);
    CHECK(recorded->curve.light.front().g == doctest::Approx(0.2));
    const auto constants = time_constants(*recorded);
    REQUIRE(constants.size() == 1);
    CHECK(constants.front().seconds * fps * std::numbers::ln2 ==
          doctest::Approx(1.0).epsilon(0.001));
}

TEST_CASE("the last of several flashes counts") {
    PixelLight pixels;
    for (int i = 0; i < 60; ++i) {
        const int frame = i % 30;
        pixels.mean.emplace_back(frame < 5 ? 0.0 : 0.8 * std::exp2(5.0 - frame));
        pixels.deviation.emplace_back(0.0);
    }
    const auto recorded = recorded_decay(light_curve(pixels, fps, 2.2));
    REQUIRE(recorded);
    CHECK(recorded->lit_frames == 1);  // the frame before it is dark
    CHECK(recorded->curve.light.front().g == doctest::Approx(0.4));
}

TEST_CASE("a video without fading light is refused") {
    const auto refusal = [](const std::vector<double>& light) {
        PixelLight pixels;
        for (const double value : light) {
            pixels.mean.emplace_back(value);
            pixels.deviation.emplace_back(0.0);
        }
        const auto recorded = recorded_decay(light_curve(pixels, fps, 2.2));
        return recorded ? std::string() : recorded.error().front().message;
    };
    CHECK(refusal({}).starts_with("The video shows no light"));
    CHECK(refusal(std::vector<double>(40, 0.001)).starts_with("The video shows no light"));
    CHECK(refusal(std::vector<double>(40, 0.5)).starts_with("The video does not show how"));
    CHECK(refusal({0.0, 0.8, 0.2, 0.1, 0.0}).starts_with("The video does not show how"));
}

TEST_CASE("noise that is cut off at black does not make the dark lighter") {
    std::mt19937 random(7);
    std::normal_distribution<double> normal;
    PixelLight pixels;
    std::vector<double> before(4096, 0.0);
    for (int frame = 0; frame < 40; ++frame) {
        const double light = frame < 20 ? 0.001 : 0.02;
        double sum = 0.0;
        double change = 0.0;
        for (double& last : before) {
            const double seen = std::max(light + 0.004 * normal(random), 0.0);
            sum += seen / 4096.0;
            change += std::pow(seen - last, 2) / 4096.0;
            last = seen;
        }
        pixels.mean.emplace_back(sum);
        pixels.deviation.emplace_back(std::sqrt(change));
    }
    CHECK(pixels.mean[5].g > 0.0018);
    const LightCurve curve = light_curve(pixels, fps, 2.2);
    CHECK(curve.light[5].g / 0.001 == doctest::Approx(1.0).epsilon(0.4));
    CHECK(curve.light[25].g / 0.02 == doctest::Approx(1.0).epsilon(0.01));
}
