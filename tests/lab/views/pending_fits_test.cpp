#include "lab/views/pending_fits.h"

#include <doctest/doctest.h>

#include <limits>

namespace {
std::optional<double> gain_for(double largest, DifferenceMeasure measure) {
    Comparison comparison;
    comparison.measure = measure;
    Distances distances;
    distances.largest = largest;
    return fitting_gain(comparison, distances);
}
}  // namespace

TEST_CASE("the fitting gain scales the largest difference to 1") {
    // 2^gain * difference = 1, or 2^gain * difference^2 = 1
    CHECK(gain_for(0.25, DifferenceMeasure::absolute) == 2.0);
    CHECK(gain_for(0.25, DifferenceMeasure::squared) == 4.0);
    CHECK(gain_for(4.0, DifferenceMeasure::absolute) == -2.0);
    CHECK(gain_for(1e-9, DifferenceMeasure::absolute) == 16.0);  // the maximum
}

TEST_CASE("without a measured difference there is no fitting gain") {
    CHECK_FALSE(gain_for(0.0, DifferenceMeasure::absolute).has_value());
    CHECK_FALSE(
        gain_for(std::numeric_limits<double>::infinity(), DifferenceMeasure::absolute).has_value());
    CHECK_FALSE(gain_for(0.25, DifferenceMeasure::relative).has_value());
    CHECK_FALSE(fitting_gain({}, std::nullopt).has_value());
}
