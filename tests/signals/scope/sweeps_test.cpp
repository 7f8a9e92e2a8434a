#include "signals/scope/sweeps.h"

#include <doctest/doctest.h>

#include <cmath>

TEST_CASE("even sweeps contain the same samples despite rounding of their period") {
    const double period = 300.0;
    for (const double rounded :
         {period, std::nextafter(period, 0.0), std::nextafter(period, 1e9)}) {
        const PeriodicSweeps sweeps(0.0, rounded, rounded);
        for (const std::int64_t number : {0, 1, 7, 100000, 20000000}) {
            CAPTURE(number);
            // Sample k is at time k + 1; a sweep covers (start, start + length].
            const std::int64_t first = number * 300;
            for (const std::int64_t sample : {first, first + 299}) {
                const auto sweep = sweeps.latest(sample);
                REQUIRE(sweep.has_value());
                CHECK(sweep->first() == first);
                CHECK(sweep->end() == first + 300);
            }
        }
    }
}

TEST_CASE("there is no sweep before the first one, and a single sweep occurs once") {
    const PeriodicSweeps sweeps(50.0, PeriodicSweeps::once, 100.0);
    CHECK_FALSE(sweeps.latest(49).has_value());
    CHECK(sweeps.latest(50)->first() == 50);
    CHECK(sweeps.latest(100000)->end() == 150);
    CHECK(sweeps.latest(99)->across(99) == 0.5);
}
