#include "model/tuning/repetition.h"

#include <doctest/doctest.h>

namespace {
std::optional<Fraction> period_of(std::initializer_list<double> hertz) {
    Repetition repetition;
    for (const double frequency : hertz)
        repetition.add(frequency);
    return common_period(repetition);
}
}  // namespace

TEST_CASE("numbers become the fractions that they were typed as") {
    CHECK(fraction_of(0.0) == Fraction{0, 1});
    CHECK(fraction_of(180.0) == Fraction{180, 1});
    CHECK(fraction_of(0.1) == Fraction{1, 10});
    CHECK(fraction_of(1.0 / 3.0) == Fraction{1, 3});
    CHECK(fraction_of(7.0 / 360.0) == Fraction{7, 360});
    CHECK(fraction_of(30000.0 / 1001.0) == Fraction{30000, 1001});
    CHECK(fraction_of(0.333333) == Fraction{333333, 1000000});
}

TEST_CASE("the common period is the least common multiple of all periods") {
    CHECK(period_of({}) == Fraction{0, 1});
    CHECK(period_of({0.0}) == Fraction{0, 1});
    CHECK(period_of({180.0, 120.0}) == Fraction{1, 60});
    CHECK(period_of({180.5, 120.0}) == Fraction{2, 1});
    CHECK(period_of({0.25, 1.0 / 3.0}) == Fraction{12, 1});
    CHECK(period_of({-0.5, 60.0}) == Fraction{2, 1});
    CHECK(period_of({30000.0 / 1001.0}) == Fraction{1001, 30000});
    CHECK(!period_of({0.000277, 60.0}));  // 1e6 / gcd(277, 6e7) s, longer than an hour
}

TEST_CASE("a period fits a frame rate if it is a whole number of frames or stands still") {
    CHECK(frames_of_period({2, 1}, 60.0) == 120);
    CHECK(frames_of_period({1, 60}, 60.0) == 1);
    CHECK(frames_of_period({1, 60}, 30.0) == 1);
    CHECK(frames_of_period({0, 1}, 24.0) == 1);
    CHECK(!frames_of_period({1, 60}, 25.0));
    CHECK(!frames_of_period({10, 3}, 25.0));
    CHECK(frames_of_period({10, 3}, 30.0) == 100);
    CHECK(frames_of_period({1001, 1000}, 30000.0 / 1001.0) == 30);
}

TEST_CASE("frame rates that fit are usual ones, otherwise the nearest") {
    CHECK(fitting_rates({10, 3}, 25.0) == std::vector<double>{24.0, 30.0, 48.0, 60.0, 120.0});
    CHECK(fitting_rates({1, 7}, 60.0) == std::vector<double>{56.0, 63.0});
}

TEST_CASE("parts of a repetition add up, and one error is enough") {
    Repetition whole;
    whole.add(0.5);
    Repetition part{.error = "noise never repeats"};
    part.add(0.75);
    whole.add(part);
    CHECK(common_period(whole) == Fraction{4, 1});
    CHECK(whole.error == "noise never repeats");
}
