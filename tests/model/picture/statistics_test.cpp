#include "model/picture/statistics.h"

#include "about.h"
#include "model/picture/levels.h"

#include <doctest/doctest.h>

#include <limits>
#include <numeric>

namespace {
constexpr float no_number = std::numeric_limits<float>::quiet_NaN();
constexpr float infinity = std::numeric_limits<float>::infinity();

Picture row(std::vector<float> numbers, int channels = 1) {
    const int width = static_cast<int>(numbers.size()) / channels;
    return {{width, 1}, channels, Encoding::linear, std::move(numbers)};
}

// 0, 1, ... 999, divided by 1000.
Picture ramp() {
    std::vector<float> numbers(1000);
    std::iota(numbers.begin(), numbers.end(), 0.0f);
    for (float& number : numbers)
        number /= 1000.0f;
    return row(std::move(numbers));
}
}  // namespace

TEST_CASE("a ramp has the expected minimum, maximum and mean, and equal bins") {
    const Statistics all = statistics_of(ramp());
    CHECK(all.minimum == 0.0);
    CHECK(all.maximum == about(0.999, 1e-6));
    CHECK(all.mean == about(0.4995, 1e-6));
    CHECK(all.finite == 1000);
    const Histogram histogram = histogram_of(ramp(), -0.0005, 0.9995, 10);
    REQUIRE(histogram.bins.size() == 1);
    CHECK(histogram.bins[0] == std::vector<std::uint32_t>(10, 100));
    CHECK(histogram.highest() == 100);
}

TEST_CASE("values outside the histogram range are counted as below or above") {
    const Histogram histogram = histogram_of(ramp(), 0.2495, 0.7495, 5);
    CHECK(histogram.below == 250);
    CHECK(histogram.above == 250);
    CHECK(histogram.finite == 1000);
    CHECK(histogram.bins[0] == std::vector<std::uint32_t>(5, 100));
}

TEST_CASE("both ends of the histogram range are inclusive") {
    const Histogram histogram = histogram_of(row({0.0f, 1.0f, 1.0f}), 0.0, 1.0, 4);
    CHECK(histogram.bins[0] == std::vector<std::uint32_t>{1, 0, 0, 2});
    CHECK(histogram.below + histogram.above == 0);
}

TEST_CASE("non-finite values are counted per pixel, and excluded from statistics") {
    const Picture picture =
        row({no_number, infinity, 5.0f, 1.0f, -infinity, 7.0f, -2.0f, 0.5f, 3.0f}, 3);
    const Statistics all = statistics_of(picture);
    CHECK(all.not_a_number == 1);
    CHECK(all.infinite == 1);
    CHECK(all.finite == 1);
    CHECK(all.minimum == -2.0);
    CHECK(all.maximum == 3.0);
    CHECK(all.mean == 0.5);
    CHECK(histogram_of(picture, 0.0, 4.0, 4).finite == 6);
    const Statistics none = statistics_of(row({no_number, infinity}));
    CHECK(none == Statistics{.not_a_number = 1, .infinite = 1});
    CHECK(fitted_levels(none) == Levels{});
}

TEST_CASE("each channel has its own bins") {
    const Histogram histogram = histogram_of(row({0, 1, 2, 0, 2, 2}, 3), 0.0, 3.0, 3);
    CHECK(histogram.bins ==
          std::vector<std::vector<std::uint32_t>>{{2, 0, 0}, {0, 1, 1}, {0, 0, 2}});
}

TEST_CASE("fitted levels span the minimum and maximum, zero included") {
    CHECK(fitted_levels(statistics_of(row({-3, 0, 12}))) == Levels{-3, 12});
    CHECK(fitted_levels(statistics_of(row({4, 4}))) == Levels{0, 4});
    CHECK(fitted_levels(statistics_of(row({-4}))) == Levels{-4, 0});
    CHECK(fitted_levels(statistics_of(row({0, 0}))) == Levels{0, 1});
}

TEST_CASE("black stays below white: moving one also moves the other") {
    CHECK(with_black({0, 1}, 0.5) == Levels{0.5, 1});
    CHECK(with_black({0, 1}, 3) == Levels{3, 4});
    CHECK(with_black({0, 1}, 1) == Levels{1, 2});
    CHECK(with_white({0, 1}, 0.25) == Levels{0, 0.25});
    CHECK(with_white({2, 4}, 1) == Levels{-1, 1});
}
