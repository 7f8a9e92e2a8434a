#include "signals/generators/harmonics.h"

#include "about.h"
#include "signals/signal_making.h"

#include <algorithm>

namespace {
float peak(const Beam& beam) {
    float highest = 0.0f;
    for (const BeamPoint& point : beam)
        highest = std::max(highest, std::abs(point.y));
    return highest;
}
}  // namespace

TEST_CASE("one harmonic is a sine") {
    const Beam beam =
        beam_of(*signal_of("harmonics:base=1,count=1,amplitude=0.8"), frame_span(1, 60.0));
    for (std::size_t i = 0; i < beam.size(); ++i)
        REQUIRE(std::abs(beam[i].y - 0.8 * sine_at(1.0, static_cast<double>(i + 1) / 4096.0)) <
                1e-5);
}

TEST_CASE("the peak equals the amplitude for any harmonics") {
    for (const char* text :
         {"harmonics:count=64,falloff=0,amplitude=0.7", "harmonics:count=2,amplitude=0.7",
          "harmonics:shape=square,amplitude=0.7"})
        CHECK(peak(beam_of(*signal_of(text), frame_span(1, 60.0))) == about(0.7, 1e-3));
}

TEST_CASE("odd alternating harmonics with fall-off 2 are the Fourier series of a triangle") {
    const Beam beam =
        beam_of(*signal_of("harmonics:base=1,count=63,falloff=2,shape=triangle,amplitude=1"),
                frame_span(1, 60.0));
    for (std::size_t i = 0; i < beam.size(); ++i) {
        const double turns = static_cast<double>(i + 1) / 4096.0;
        const double triangle = 2.0 / std::numbers::pi * std::asin(sine_at(1.0, turns));
        REQUIRE(std::abs(beam[i].y - triangle) < 0.015);
    }
}

TEST_CASE("odd harmonics with fall-off 1 are the Fourier series of a square wave") {
    const Beam beam =
        beam_of(*signal_of("harmonics:base=1,count=5,falloff=1,shape=square,amplitude=1"),
                frame_span(1, 60.0));
    const auto sum = [](double turns) {
        return sine_at(1, turns) + sine_at(3, turns) / 3 + sine_at(5, turns) / 5;
    };
    const double ratio = beam[511].y / sum(512.0 / 4096.0);
    for (std::size_t i = 0; i < beam.size(); ++i)
        REQUIRE(std::abs(beam[i].y - ratio * sum(static_cast<double>(i + 1) / 4096.0)) < 1e-4);
}
