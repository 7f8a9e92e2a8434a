#pragma once

#include <cstdint>
#include <vector>

/// The sums of a least-squares problem with n unknowns: r is the residual, J its derivatives.
struct NormalEquations {
    explicit NormalEquations(std::size_t unknowns)
        : n(unknowns), squares(unknowns * unknowns), slopes(unknowns) {}

    std::size_t n;
    std::vector<double> squares;  // J^T J, row by row
    std::vector<double> slopes;   // J^T r
    double cost = 0.0;            // r^T r / 2
    double count = 0.0;           // of residuals

    NormalEquations& operator+=(const NormalEquations& other);
};

/// The derivatives of all residuals by one unknown.
struct Derivatives {
    std::vector<float> smooth;      // without noise, for J^T J
    std::vector<float> exact = {};  // for J^T r; empty: as `smooth`
};

/// The sums of each group. `groups`: the group of each residual, below `count`.
std::vector<NormalEquations> summed(const std::vector<Derivatives>& columns,
                                    const std::vector<float>& residuals,
                                    const std::vector<std::uint16_t>& groups, std::size_t count);

/// The step within bounds that minimises the linearised cost. Bounds are relative to the present
/// values, so they contain 0. Computed by an active set: unknowns that would leave their bounds
/// stay there.
std::vector<double> bounded_step(const NormalEquations& equations, const std::vector<double>& low,
                                 const std::vector<double>& high);

/// The variance of a residual, if residuals were independent, that gives the solution the
/// covariance below on average. It is larger than their mean square, because colour filters, JPEG
/// and lens make errors that neighbours share. What is known before the photo is weighed against
/// it.
double noise_variance(const NormalEquations& total, const std::vector<NormalEquations>& groups);

/// The covariance of the solution, row by row, from groups whose errors are independent
/// (cluster-robust, Liang and Zeger 1986, with the factor G / (G - n)). It is 4 times as large for
/// errors that all groups share. `total` is the sum of the
/// groups, and may include a prior.
std::vector<double> covariance(const NormalEquations& total,
                               const std::vector<NormalEquations>& groups);
