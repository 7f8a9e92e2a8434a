#include "io/sound/device_watch.h"

#include <doctest/doctest.h>

using namespace std::chrono_literals;

namespace {
constexpr DeviceWatch::Clock::time_point watch_start{100s};
}

TEST_CASE("a device times out after four seconds at the start, and one second between buffers") {
    DeviceWatch watch;
    watch.start(watch_start);
    CHECK_FALSE(watch.is_lost(watch_start + 3900ms));
    CHECK(watch.is_lost(watch_start + 4100ms));
    CHECK(watch.served(0.01, watch_start + 1200ms));
    CHECK_FALSE(watch.is_lost(watch_start + 2100ms));
    CHECK(watch.is_lost(watch_start + 2300ms));
}

TEST_CASE("a device that takes two seconds at once and is slightly fast is not a runaway") {
    DeviceWatch watch;
    watch.start(watch_start);
    for (int n = 0; n < 10000; ++n) {
        const auto now = watch_start + n * 1998ms;
        for (int buffer = 0; buffer < 20; ++buffer)
            REQUIRE(watch.served(0.1, now));
        REQUIRE_FALSE(watch.is_lost(now));
    }
}

TEST_CASE("a stream that consumes samples much too fast is stopped and stays lost") {
    DeviceWatch watch;
    watch.start(watch_start);
    int served = 0;
    while (served < 100000 && watch.served(0.01, watch_start + served * 2us))
        ++served;
    CHECK(served >= 500);  // five seconds of sound
    CHECK(served < 510);
    CHECK(watch.is_lost(watch_start + 10ms));
    CHECK_FALSE(watch.served(0.01, watch_start + 60s));
    CHECK(watch.is_lost(watch_start + 60s));
}
