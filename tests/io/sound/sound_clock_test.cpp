#include "io/sound/sound_clock.h"

#include "about.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace std::chrono_literals;

namespace {
const SoundClock::Time clock_start = SoundClock::Time{} + 100s;
}

TEST_CASE("between buffers the clock runs at the sound's speed, delayed by the latency") {
    SoundClock clock;
    clock.buffer_filled({.begin_seconds = 5.0, .seconds_per_second = 2.0, .jump = 0}, clock_start);
    CHECK(clock.heard_seconds(clock_start + 8ms, 0.004) == doctest::Approx(5.0 + 0.004 * 2.0));
    CHECK(clock.heard_seconds(clock_start + 12ms, 0.004) == doctest::Approx(5.0 + 0.008 * 2.0));
}

TEST_CASE("irregular buffers of a slightly fast device give a smooth clock without drift") {
    SoundClock clock;
    double last = 0.0;
    std::int64_t bursts = 0;
    for (std::int64_t n = 1; n <= 1200; ++n) {
        const auto now = clock_start + n * 16667us;
        for (; clock_start + bursts * 40ms <= now; ++bursts)
            clock.buffer_filled({.begin_seconds = static_cast<double>(bursts) * 0.04 * 1.001,
                                 .seconds_per_second = 1.0,
                                 .jump = 0},
                                clock_start + bursts * 40ms);
        const double heard = clock.heard_seconds(now, 0.04);
        if (n > 120) {
            REQUIRE(heard - last == about(0.016667, 0.02));
            REQUIRE(std::abs(heard - (static_cast<double>(n) * 0.016667 * 1.001 - 0.04)) < 0.002);
        }
        last = heard;
    }
}

TEST_CASE("the clock never runs backwards") {
    SoundClock clock;
    clock.buffer_filled({.begin_seconds = 5.0, .seconds_per_second = 1.0, .jump = 0}, clock_start);
    const double before = clock.heard_seconds(clock_start + 15ms, 0.0);
    clock.buffer_filled({.begin_seconds = 1.0, .seconds_per_second = 1.0, .jump = 0},
                        clock_start + 16ms);
    CHECK(clock.heard_seconds(clock_start + 17ms, 0.0) == before);
}

TEST_CASE("after a seek the clock shows the target until a buffer follows") {
    SoundClock clock;
    clock.buffer_filled({.begin_seconds = 5.0, .seconds_per_second = 1.0, .jump = 0}, clock_start);
    CHECK(clock.heard_seconds(clock_start, 0.0) == 5.0);
    clock.seek_started(1, 2.0);
    CHECK(clock.heard_seconds(clock_start + 5ms, 0.0) == 2.0);
    clock.buffer_filled({.begin_seconds = 2.0, .seconds_per_second = 1.0, .jump = 1},
                        clock_start + 10ms);
    CHECK(clock.heard_seconds(clock_start + 14ms, 0.0) == doctest::Approx(2.004));
}

TEST_CASE("when paused or at the end, the clock runs to the last played position and stops") {
    SoundClock clock;
    CHECK(clock.heard_seconds(clock_start, 0.0) == 0.0);
    clock.buffer_filled({.begin_seconds = 1.0, .seconds_per_second = 1.0, .jump = 0}, clock_start);
    CHECK(clock.heard_seconds(clock_start + 1ms, 0.041) == doctest::Approx(0.96));
    clock.buffer_filled({.begin_seconds = 1.01, .seconds_per_second = 0.0, .jump = 0},
                        clock_start + 10ms);
    CHECK(clock.heard_seconds(clock_start + 11ms, 0.041) == doctest::Approx(0.97));
    CHECK(clock.heard_seconds(clock_start + 90ms, 0.041) == 1.01);
    CHECK(clock.heard_seconds(clock_start + 5s, 0.041) == 1.01);
}

TEST_CASE("the clock stops when the device is gone") {
    SoundClock clock;
    clock.buffer_filled({.begin_seconds = 1.0, .seconds_per_second = 1.0, .jump = 0}, clock_start);
    clock.heard_seconds(clock_start + 9ms, 0.0);
    for (int n = 1; n <= 300; ++n)
        clock.heard_seconds(clock_start + n * 33ms, 0.0);
    CHECK(clock.heard_seconds(clock_start + 10s, 0.0) == doctest::Approx(1.1));
}
