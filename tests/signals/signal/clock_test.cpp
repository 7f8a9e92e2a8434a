#include "signals/signal/clock.h"

#include <doctest/doctest.h>

#include <cmath>
#include <initializer_list>

TEST_CASE("frame n covers the time from (n - 1) / fps to n / fps") {
    CHECK(frame_span(1, 60.0) == TimeSpan{0.0, 1.0 / 60.0});
    CHECK(frame_span(90, 30.0).end == 3.0);
    CHECK(frame_span(90, 30.0).seconds() == doctest::Approx(1.0 / 30.0));
}

TEST_CASE("sample k is at (k + 1) / rate, and a span includes its end but not its start") {
    const SampleRange first = samples_in({0.0, 0.5}, 10.0);
    CHECK(first.first == 0);
    CHECK(first.end == 5);  // 0.1 .. 0.5
    const SampleRange next = samples_in({0.5, 0.59}, 10.0);
    CHECK(next.first == 5);
    CHECK(next.count() == 0);  // 0.6 is later
    CHECK(samples_in({-1.0, 0.05}, 10.0).count() == 0);
}

TEST_CASE("every frame of an hour has the same number of samples, without gaps") {
    constexpr std::int64_t frames_of_an_hour = 216000;
    for (const double rate : {44100.0 * 4.0, 48000.0 * 16.0, 4096.0 * 60.0}) {
        const auto each = static_cast<std::int64_t>(rate / 60.0);
        std::int64_t next = 0;
        std::int64_t uneven = 0;
        for (std::int64_t n = 1; n <= frames_of_an_hour; ++n) {
            const SampleRange instants = samples_in(frame_span(n, 60.0), rate);
            uneven += instants.first != next || instants.count() != each;
            next = instants.end;
        }
        CHECK(uneven == 0);
        CHECK(next == static_cast<std::int64_t>(rate) * 3600);
    }
}

TEST_CASE("frames have the same number of samples after days") {
    constexpr double rate = 48000.0 * 4.0;
    constexpr std::int64_t frames_of_a_week = 7LL * 24 * 216000;
    std::int64_t uneven = 0;
    for (std::int64_t n = frames_of_a_week; n < frames_of_a_week + 2000; ++n)
        uneven += samples_in(frame_span(n, 60.0), rate).count() != 3200;
    CHECK(uneven == 0);
}

TEST_CASE("accumulated and divided frame times give the same samples") {
    double added = 0.0;
    std::int64_t different = 0;
    for (std::int64_t n = 1; n <= 600; ++n) {
        const double next = added + 1.0 / 60.0;
        const SampleRange sum = samples_in({added, next}, 48000.0 * 4.0);
        const SampleRange quotient = samples_in(frame_span(n, 60.0), 48000.0 * 4.0);
        different += sum.first != quotient.first || sum.end != quotient.end;
        added = next;
    }
    CHECK(different == 0);
}

TEST_CASE("non-finite and reversed spans are empty") {
    CHECK(samples_in({0.0, std::nan("")}, 48000.0).count() == 0);
    CHECK(samples_in({5.0, 1.0}, 48000.0).count() == 0);
}
