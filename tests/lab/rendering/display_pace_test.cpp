// The refresh rate, drops and sub-frames of a display, with the times of its refreshes injected.
#include "lab/rendering/display_pace.h"

#include <doctest/doctest.h>

#include <cmath>

namespace {
/// `seconds` of a display that reports `reported` Hz and runs at `real` Hz. Each `late`-th picture
/// comes one refresh late; 0: none.
DisplayPace pace_of(double reported, double real, int late = 0, double seconds = 2.0) {
    DisplayPace pace;
    int refresh = 0;
    for (int picture = 1; refresh < seconds * real; ++picture) {
        const int refreshes = late > 0 && picture % late == 0 ? 2 : 1;
        pace.add(refreshes / real, reported, true);
        refresh += refreshes;
    }
    return pace;
}
}  // namespace

TEST_CASE("the refresh rate of a display is measured, not the one that it reports") {
    for (const double real : {59.94, 99.9, 143.86, 239.76})
        CHECK(std::abs(pace_of(std::round(real), real).refresh_rate() - real) < 1e-6);
    DisplayPace fresh;
    CHECK(fresh.refresh_rate() == 0.0);
    fresh.add(1.0 / 144.0, 144.0, true);
    CHECK(fresh.refresh_rate() == 144.0);
}

TEST_CASE("refreshes that showed the previous picture again are drops of the last second") {
    CHECK(pace_of(240.0, 239.76).drops() == 0);
    const DisplayPace late =
        pace_of(240.0, 239.76, 24);  // one of 25 refreshes shows no new picture
    CHECK(late.drops() >= 9);
    CHECK(late.drops() <= 10);
    CHECK(std::abs(late.refresh_rate() - 239.76) < 1e-6);
    CHECK(std::abs(late.pictures_per_second() - 239.76 * 24.0 / 25.0) < 0.5);
}

TEST_CASE("sub-frames leave at least 50 source pictures a second") {
    struct Row {
        double rate;
        int subframes;
    };
    for (const Row& row : {Row{59.94, 1}, Row{75.0, 1}, Row{99.9, 2}, Row{119.88, 2},
                           Row{143.86, 2}, Row{164.8, 3}, Row{239.76, 4}, Row{360.0, 7}})
        CHECK(pace_of(std::round(row.rate), row.rate).most_subframes() == row.subframes);
    // A machine that draws only each fourth picture in time.
    DisplayPace slow;
    for (int picture = 0; picture < 120; ++picture)
        slow.add(4.0 / 240.0, 240.0, true);
    CHECK(slow.drops() >= 175);
    CHECK(slow.most_subframes() == 1);
}

TEST_CASE("a pause and another display start the measurement anew") {
    DisplayPace pace = pace_of(240.0, 240.0);
    REQUIRE(pace.most_subframes() == 4);
    pace.add(1.0 / 240.0, 240.0, false);
    CHECK(pace.most_subframes() == 1);
    CHECK(pace.drops() == 0);
    pace = pace_of(240.0, 240.0);
    pace.add(1.0 / 60.0, 60.0, true);
    CHECK(pace.refresh_rate() == 60.0);
    CHECK(pace.most_subframes() == 1);
}
