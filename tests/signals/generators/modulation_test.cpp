#include "signals/generators/modulation.h"

#include "about.h"
#include "signals/signal_making.h"

#include <algorithm>

namespace {
int rising_crossings(const Beam& beam) {
    int count = 0;
    for (std::size_t i = 1; i < beam.size(); ++i)
        count += beam[i - 1].y < 0.0f && beam[i].y >= 0.0f;
    return count;
}
}  // namespace

TEST_CASE("am: the envelope ranges from (1 - d) / (1 + d) to 1 of the amplitude") {
    const Beam beam = beam_of(*signal_of("am:carrier=64,modulator=1,depth=0.5,amplitude=0.9"),
                              frame_span(1, 60.0));
    const auto highest_around = [&](std::size_t place) {
        float highest = 0.0f;
        for (std::size_t i = place - 40; i < place + 40; ++i)
            highest = std::max(highest, beam[i].y);
        return highest;
    };
    CHECK(highest_around(1024) == about(0.9, 0.01));
    CHECK(highest_around(3072) == about(0.9 / 3.0, 0.01));
}

TEST_CASE("fm: index 0 is the plain carrier; otherwise the frequency swings by index * modulator") {
    const Beam plain =
        beam_of(*signal_of("fm:carrier=10,modulator=1,index=0,amplitude=1"), frame_span(1, 60.0));
    for (std::size_t i = 0; i < plain.size(); ++i)
        REQUIRE(std::abs(plain[i].y - sine_at(10.0, static_cast<double>(i + 1) / 4096.0)) < 1e-6);

    const Beam swung =
        beam_of(*signal_of("fm:carrier=20,modulator=1,index=10,amplitude=1"), frame_span(1, 60.0));
    const Beam first(swung.begin(), swung.begin() + 512);           // about 20 + 9 periods
    const Beam middle(swung.begin() + 1792, swung.begin() + 2304);  // about 20 - 9.9
    CHECK(rising_crossings(first) >= 3);
    CHECK(rising_crossings(middle) <= 2);
}

TEST_CASE("in xy an unmodulated carrier is a circle") {
    const Beam beam = beam_of(*signal_of("am:carrier=8,modulator=1,depth=0,amplitude=0.5,mode=xy"),
                              frame_span(4, 60.0));
    for (const BeamPoint& point : beam)
        REQUIRE(std::hypot(point.x, point.y) == about(0.5, 1e-6));
}
