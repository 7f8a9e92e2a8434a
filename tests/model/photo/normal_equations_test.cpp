#include "model/photo/normal_equations.h"

#include <doctest/doctest.h>

#include <random>

namespace {
// y = a + b x at x = 0, 1, 2, 3 in two groups; the residual is the model minus y at a = b = 0.
NormalEquations line(std::vector<NormalEquations>* groups = nullptr) {
    const std::vector<float> y{1.0F, 3.0F, 5.0F, 7.5F};
    const std::vector<Derivatives> columns{{{1, 1, 1, 1}}, {{0, 1, 2, 3}}};
    const auto sums = summed(columns, {-y[0], -y[1], -y[2], -y[3]}, {0, 0, 1, 1}, 2);
    NormalEquations total(2);
    for (const NormalEquations& group : sums)
        total += group;
    if (groups)
        *groups = sums;
    return total;
}
}  // namespace

TEST_CASE("a step without active bounds is the line of least squares") {
    const auto step = bounded_step(line(), {-10, -10}, {10, 10});
    CHECK(step[0] == doctest::Approx(0.9));
    CHECK(step[1] == doctest::Approx(2.15));
}

TEST_CASE("a bounded unknown stays at its bound, and the others are the best for it") {
    const auto step = bounded_step(line(), {-10, -10}, {10, 2.0});
    CHECK(step[1] == doctest::Approx(2.0));
    CHECK(step[0] == doctest::Approx(4.125 - 2.0 * 1.5));
}

TEST_CASE("exact derivatives change the slope of the cost, not its curvature") {
    const std::vector<Derivatives> columns{{{1, 1}, {2, 2}}};
    const auto sums = summed(columns, {3, 4}, {0, 0}, 1);
    CHECK(sums[0].squares[0] == doctest::Approx(2.0));
    CHECK(sums[0].slopes[0] == doctest::Approx(14.0));
    CHECK(sums[0].cost == doctest::Approx(12.5));
}

TEST_CASE("the covariance of a mean of groups is that of the groups' errors") {
    // A constant with G groups of equal errors e_g: the variance of the mean is s^2 / G.
    std::mt19937 random(1);
    std::normal_distribution<float> error(0.0F, 2.0F);
    constexpr std::size_t count = 2000;
    constexpr std::size_t size = 5;
    Derivatives column;
    std::vector<float> residuals;
    std::vector<std::uint16_t> groups;
    for (std::size_t group = 0; group < count; ++group) {
        const float shared = error(random);
        for (std::size_t i = 0; i < size; ++i) {
            column.smooth.push_back(1.0F);
            residuals.push_back(shared);
            groups.push_back(static_cast<std::uint16_t>(group));
        }
    }
    const auto sums = summed({column}, residuals, groups, count);
    NormalEquations total(1);
    for (const NormalEquations& group : sums)
        total += group;
    constexpr double shared = 4.0;  // for errors that all groups share
    CHECK(covariance(total, sums)[0] * count / (shared * 4.0) == doctest::Approx(1.0).epsilon(0.1));
    // Independent residuals with this variance would give the same.
    CHECK(noise_variance(total, sums) / (shared * 4.0 * size) == doctest::Approx(1.0).epsilon(0.1));
}
