#include "lab/heavy_pass.h"

#include <doctest/doctest.h>

namespace {
PassTimes times_of(const std::vector<std::vector<double>>& frames) {
    PassTimes times;
    for (const std::vector<double>& frame : frames)
        times.add(frame);
    return times;
}
}  // namespace

TEST_CASE("a pass that takes more than a second in each of the last four frames is heavy") {
    const std::vector<double> light{20.0, 1000.0};
    const std::vector<double> heavy{20.0, 1001.0};
    CHECK_FALSE(heavy_pass({}).has_value());
    CHECK_FALSE(heavy_pass(times_of({heavy, heavy, heavy})).has_value());
    CHECK_FALSE(heavy_pass(times_of({heavy, heavy, light, heavy})).has_value());
    CHECK(heavy_pass(times_of({light, heavy, heavy, heavy, heavy})) == 1);
    CHECK_FALSE(heavy_pass(times_of({heavy, heavy, heavy, heavy, light})).has_value());
}

TEST_CASE("a time that cannot be is passed over") {
    const std::vector<double> wild{5e6};
    CHECK_FALSE(heavy_pass(times_of({wild, wild, wild, wild})).has_value());
}
