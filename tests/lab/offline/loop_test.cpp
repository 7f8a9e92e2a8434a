#include "lab/offline/loop.h"

#include "lab/playback/played_signal.h"

#include <doctest/doctest.h>

namespace {
// The period of a series whose pictures have one pixel, and after how many pictures it is found.
std::pair<std::int64_t, int> found(PeriodFinder finder, int (*picture)(int)) {
    for (int i = 0; i < 1000; ++i)
        if (const auto period = finder.add({static_cast<std::uint8_t>(picture(i))}))
            return {*period, i + 1};
    return {0, 0};
}
}  // namespace

TEST_CASE("the smallest period is found once it has been drawn twice") {
    const auto saw = [](int i) { return 20 * (i % 7); };
    CHECK(found(PeriodFinder(1, 50, 1), saw) == std::pair<std::int64_t, int>(7, 14));
    CHECK(found(PeriodFinder(2, 50, 1), saw).first == 14);
    CHECK(found(PeriodFinder(1, 5, 1), saw).first == 0);
    CHECK(found(PeriodFinder(1, 50, 60), saw) == std::pair<std::int64_t, int>(7, 67));
}

TEST_CASE("a look that still brightens has no period yet") {
    const auto settling = [](int i) { return i < 40 ? 4 * i : 160 + 10 * (i % 2); };
    const auto [period, count] = found(PeriodFinder(1, 50, 1), settling);
    CHECK(period == 2);
    CHECK(count > 41);
}

TEST_CASE("a still picture is a period of one frame") {
    CHECK(found(PeriodFinder(1, 50, 10), [](int i) { return 100 + i % 2; }) ==
          std::pair<std::int64_t, int>(1, 11));
}

TEST_CASE("a period that is no whole number of frames is refused with the rates that fit") {
    CHECK(loop_frames({10, 3}, 30.0).value() == 100);
    const auto refused = loop_frames({10, 3}, 25.0);
    REQUIRE(!refused.has_value());
    CHECK(refused.error().front().message ==
          "the picture repeats after 3.33333 s, which is not a whole number of frames at 25 fps. "
          "Frame rates that fit: 24, 30, 48, 60, 120.");
}

TEST_CASE("an LFO in beats repeats with the tempo") {
    Document document{Look{}};
    document.amend([](DocumentState& state) {
        state.tempo.bpm = 96.0;  // 0.625 s per beat
        state.modulations["brightness"] = {.is_in_beats = true, .period = 8.0};
    });
    const PlayedSignal no_signal(BeamInput::Pace::waiting, 0.0);
    CHECK(common_period(repetition_of(document, no_signal)) == Fraction{5, 1});
}
