#include "model/photo/normal_equations.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace {
using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
using Vector = Eigen::VectorXd;

Eigen::Map<const Matrix> squares_of(const NormalEquations& equations) {
    const auto n = static_cast<Eigen::Index>(equations.n);
    return {equations.squares.data(), n, n};
}

Eigen::Map<const Vector> slopes_of(const NormalEquations& equations) {
    return {equations.slopes.data(), static_cast<Eigen::Index>(equations.n)};
}

// Lengths of unknowns with the same effect on the cost.
Vector unit_scale(const NormalEquations& equations) {
    return squares_of(equations).diagonal().cwiseMax(1e-12).cwiseSqrt().cwiseInverse();
}

// How much larger errors are than those of independent groups: the model of the camera, JPEG and
// the pixel grid make errors that a whole photo shares. Measured on synthetic photos, see
// docs/match.md.
constexpr double shared_errors = 2.0;

// The covariance of the sum of slopes.
Matrix spread_of_slopes(const std::vector<NormalEquations>& groups) {
    const auto n = static_cast<Eigen::Index>(groups.front().n);
    const auto count = static_cast<double>(groups.size());
    Vector mean = Vector::Zero(n);
    for (const NormalEquations& group : groups)
        mean += slopes_of(group) / count;
    Matrix spread = Matrix::Zero(n, n);
    for (const NormalEquations& group : groups) {
        const Vector slopes = slopes_of(group) - mean;
        spread += slopes * slopes.transpose();
    }
    // Residuals are smaller than errors, as in a sample of `count` with n fitted numbers.
    const double free = std::max(count - static_cast<double>(n), 1.0);
    return shared_errors * shared_errors * count / free * spread;
}

double dot(const float* one, const float* other, std::size_t count) {
    double sum = 0.0;
    for (std::size_t i = 0; i < count; ++i)
        sum += static_cast<double>(one[i]) * static_cast<double>(other[i]);
    return sum;
}
}  // namespace

NormalEquations& NormalEquations::operator+=(const NormalEquations& other) {
    for (std::size_t i = 0; i < squares.size(); ++i)
        squares[i] += other.squares[i];
    for (std::size_t i = 0; i < slopes.size(); ++i)
        slopes[i] += other.slopes[i];
    cost += other.cost;
    count += other.count;
    return *this;
}

std::vector<NormalEquations> summed(const std::vector<Derivatives>& columns,
                                    const std::vector<float>& residuals,
                                    const std::vector<std::uint16_t>& groups, std::size_t count) {
    const std::size_t n = columns.size();
    std::vector<NormalEquations> sums(count, NormalEquations(n));
    // Rows of one group follow each other, so products of runs of rows are matrix products.
    constexpr std::size_t longest_run = 512;
    using Block = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic>;
    Block block(longest_run, static_cast<Eigen::Index>(n) + 1);
    for (std::size_t start = 0; start < residuals.size();) {
        std::size_t end = start;
        while (end < residuals.size() && end < start + longest_run && groups[end] == groups[start])
            ++end;
        const auto rows = static_cast<Eigen::Index>(end - start);
        for (std::size_t i = 0; i < n; ++i)
            std::copy_n(&columns[i].smooth[start], end - start,
                        block.col(static_cast<Eigen::Index>(i)).data());
        std::copy_n(&residuals[start], end - start, block.col(static_cast<Eigen::Index>(n)).data());
        const auto part = block.topRows(rows);
        const Block product = part.transpose() * part;
        NormalEquations& sum = sums[groups[start]];
        for (std::size_t i = 0; i < n; ++i) {
            const auto row = static_cast<Eigen::Index>(i);
            for (std::size_t j = 0; j < n; ++j)
                sum.squares[i * n + j] +=
                    static_cast<double>(product(row, static_cast<Eigen::Index>(j)));
            sum.slopes[i] += columns[i].exact.empty()
                                 ? static_cast<double>(product(row, static_cast<Eigen::Index>(n)))
                                 : dot(&columns[i].exact[start], &residuals[start], end - start);
        }
        sum.cost += 0.5 * static_cast<double>(
                              product(static_cast<Eigen::Index>(n), static_cast<Eigen::Index>(n)));
        sum.count += static_cast<double>(rows);
        start = end;
    }
    return sums;
}

std::vector<double> bounded_step(const NormalEquations& equations, const std::vector<double>& low,
                                 const std::vector<double>& high) {
    const auto n = static_cast<Eigen::Index>(equations.n);
    const Vector scale = unit_scale(equations);
    const Matrix squares = scale.asDiagonal() * squares_of(equations) * scale.asDiagonal();
    const Vector slopes = slopes_of(equations).cwiseProduct(scale);
    Vector step = Vector::Zero(n);
    std::vector<bool> is_fixed(equations.n, false);
    for (std::size_t round = 0; round < equations.n; ++round) {
        std::vector<Eigen::Index> loose;
        for (Eigen::Index i = 0; i < n; ++i)
            if (!is_fixed[static_cast<std::size_t>(i)])
                loose.push_back(i);
        if (loose.empty())
            break;
        Vector fixed_part = step;
        for (const Eigen::Index i : loose)
            fixed_part[i] = 0.0;
        const Vector right = -slopes - squares * fixed_part;
        const Vector solved = Matrix(squares(loose, loose)).ldlt().solve(Vector(right(loose)));
        bool is_within = true;
        for (std::size_t k = 0; k < loose.size(); ++k) {
            const auto i = static_cast<std::size_t>(loose[k]);
            const double wanted = solved[static_cast<Eigen::Index>(k)] * scale[loose[k]];
            const double allowed = std::clamp(wanted, low[i], high[i]);
            is_fixed[i] = allowed != wanted;
            is_within = is_within && !is_fixed[i];
            step[loose[k]] = allowed / scale[loose[k]];
        }
        if (is_within)
            break;
    }
    std::vector<double> result(equations.n);
    for (Eigen::Index i = 0; i < n; ++i)
        result[static_cast<std::size_t>(i)] = step[i] * scale[i];
    return result;
}

double noise_variance(const NormalEquations& total, const std::vector<NormalEquations>& groups) {
    constexpr double tiny = 1e-9;  // for unknowns without an effect
    const auto n = static_cast<Eigen::Index>(total.n);
    const Vector scale = unit_scale(total);
    const Matrix squares = scale.asDiagonal() * squares_of(total) * scale.asDiagonal();
    const Matrix middle = scale.asDiagonal() * spread_of_slopes(groups) * scale.asDiagonal();
    const Matrix ratio = (squares + tiny * Matrix::Identity(n, n)).ldlt().solve(middle);
    const auto effective = static_cast<double>((squares.diagonal().array() > 0.5).count());
    return ratio.trace() / std::max(effective, 1.0);
}

std::vector<double> covariance(const NormalEquations& total,
                               const std::vector<NormalEquations>& groups) {
    const auto n = static_cast<Eigen::Index>(total.n);
    const Matrix inverse = squares_of(total).ldlt().solve(Matrix::Identity(n, n));
    const Matrix result = inverse * spread_of_slopes(groups) * inverse;
    return {result.data(), result.data() + result.size()};
}
