#include "model/picture/decay_curve.h"

#include "about.h"

#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

namespace {
struct Samples {
    std::vector<double> seconds;
    std::vector<double> light;
};

Samples sampled(const std::function<double(double)>& light, double fps, double length) {
    Samples samples;
    for (int i = 0; i <= static_cast<int>(std::lround(length * fps)); ++i) {
        samples.seconds.push_back(i / fps);
        samples.light.push_back(light(i / fps));
    }
    return samples;
}

DecayCurve decay_curve(const Samples& samples) {
    return ::decay_curve(samples.seconds, samples.light);
}
}  // namespace

TEST_CASE("an exponential decay is measured exactly at any frame rate") {
    constexpr double rate = 5.0;  // per second: exp(-5 t)
    for (const double fps : {24.0, 60.0, 144.0}) {
        const DecayCurve decay =
            decay_curve(sampled([](double t) { return 3.0 * std::exp(-rate * t); }, fps, 2.0));
        CHECK(decay.peak == 3.0);
        CHECK(decay.peak_seconds == 0.0);
        REQUIRE((decay.to_tenth && decay.to_hundredth && decay.to_thousandth && decay.half_life));
        CHECK(*decay.to_tenth == about(std::log(10.0) / rate, 1e-9));
        CHECK(*decay.to_hundredth == about(std::log(100.0) / rate, 1e-9));
        CHECK(*decay.to_thousandth == about(std::log(1000.0) / rate, 1e-9));
        CHECK(*decay.half_life == about(std::numbers::ln2 / rate, 1e-9));
    }
}

TEST_CASE("times are measured from the peak, even a late one") {
    const auto late = [](double t) { return t < 0.25 ? 0.1 * t : std::exp(-8.0 * (t - 0.25)); };
    const DecayCurve decay = decay_curve(sampled(late, 60.0, 2.0));
    CHECK(decay.peak_seconds == about(0.25, 1e-12));
    REQUIRE(decay.to_tenth);
    CHECK(*decay.to_tenth == about(std::log(10.0) / 8.0, 1e-9));
}

TEST_CASE("a power law has the times of its own formula") {
    // 1 / (1 + 20 t): 1/10 at 9/20 s, 1/100 at 99/20 s
    const DecayCurve decay =
        decay_curve(sampled([](double t) { return 1.0 / (1.0 + 20.0 * t); }, 60.0, 6.0));
    REQUIRE((decay.to_tenth && decay.to_hundredth));
    CHECK(*decay.to_tenth == about(9.0 / 20.0, 1e-3));
    CHECK(*decay.to_hundredth == about(99.0 / 20.0, 1e-3));
    CHECK_FALSE(decay.to_thousandth);  // 999/20 s
}

TEST_CASE("a decay that rises again is not over") {
    const auto echo = [](double t) { return t > 0.9 && t < 1.1 ? 0.5 : std::exp(-10.0 * t); };
    const DecayCurve decay = decay_curve(sampled(echo, 100.0, 2.0));
    REQUIRE(decay.to_tenth);
    CHECK(*decay.to_tenth > 1.08);
}

TEST_CASE("a decay within one sample is interpolated, and has no half-life") {
    const DecayCurve decay = decay_curve({{0.0, 0.02, 0.04}, {1.0, 0.0, 0.0}});
    REQUIRE(decay.to_tenth);
    CHECK(*decay.to_tenth == about(0.018, 1e-9));  // linear interpolation
    CHECK_FALSE(decay.half_life);
}

TEST_CASE("no light and constant light have no decay times") {
    CHECK(decay_curve({{0.0, 1.0}, {0.0, 0.0}}) == DecayCurve{});
    CHECK(decay_curve(Samples{}) == DecayCurve{});
    const DecayCurve stays = decay_curve({{0.0, 1.0, 2.0}, {1.0, 1.0, 1.0}});
    CHECK(stays.peak == 1.0);
    CHECK_FALSE(stays.to_tenth);
    CHECK_FALSE(stays.half_life);
}
