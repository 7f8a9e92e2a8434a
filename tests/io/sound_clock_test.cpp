#include "io/sound_clock.h"

#include <doctest/doctest.h>

using namespace std::chrono_literals;

namespace {
const SoundClock::Time start = SoundClock::Time{} + 100s;
}

TEST_CASE("between buffers the clock goes on at the sound's speed, late by the latency") {
    SoundClock clock(0.010);
    clock.buffer_filled({.begin_seconds = 5.0, .seconds_per_second = 2.0, .jump = 0}, start);
    CHECK(clock.heard_seconds(start + 8ms, 0.004) == doctest::Approx(5.0 + 0.004 * 2.0));
}

TEST_CASE("it never runs back, whatever the device's buffers say") {
    SoundClock clock(0.010);
    clock.buffer_filled({.begin_seconds = 5.0, .seconds_per_second = 1.0, .jump = 0}, start);
    const double before = clock.heard_seconds(start + 15ms, 0.0);
    clock.buffer_filled({.begin_seconds = 5.01, .seconds_per_second = 1.0, .jump = 0},
                        start + 16ms);
    CHECK(clock.heard_seconds(start + 16ms, 0.0) == before);
    CHECK(clock.heard_seconds(start + 22ms, 0.0) == doctest::Approx(5.016));
}

TEST_CASE("after a jump it shows the goal until a buffer follows it, also backwards") {
    SoundClock clock(0.010);
    clock.buffer_filled({.begin_seconds = 5.0, .seconds_per_second = 1.0, .jump = 0}, start);
    CHECK(clock.heard_seconds(start, 0.0) == 5.0);
    clock.jumped(1, 2.0);
    CHECK(clock.heard_seconds(start + 5ms, 0.0) == 2.0);
    clock.buffer_filled({.begin_seconds = 2.0, .seconds_per_second = 1.0, .jump = 1}, start + 10ms);
    CHECK(clock.heard_seconds(start + 14ms, 0.0) == doctest::Approx(2.004));
}

TEST_CASE("it stands still when paused, before the first buffer and when the device is gone") {
    SoundClock clock(0.010);
    CHECK(clock.heard_seconds(start, 0.0) == 0.0);
    clock.buffer_filled({.begin_seconds = 1.0, .seconds_per_second = 0.0, .jump = 0}, start);
    CHECK(clock.heard_seconds(start + 9ms, 0.0) == 1.0);
    clock.buffer_filled({.begin_seconds = 1.0, .seconds_per_second = 1.0, .jump = 0}, start);
    CHECK(clock.heard_seconds(start + 10s, 0.0) == doctest::Approx(1.02));
    CHECK(clock.seconds_since_buffer(start + 10s) == doctest::Approx(10.0));
}
