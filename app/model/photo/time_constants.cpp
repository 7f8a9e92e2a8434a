#include "model/photo/time_constants.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace {
using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;

// The sum of the channels, divided by its standard deviations.
struct Series {
    Vector light;
    Vector weight;       // 1 / standard deviation
    double frame = 0.0;  // seconds
};

Series series_of(const LightCurve& curve) {
    const auto count = static_cast<Eigen::Index>(curve.light.size());
    Series series{Vector(count), Vector(count), 1.0 / curve.fps};
    for (Eigen::Index i = 0; i < count; ++i) {
        const auto index = static_cast<std::size_t>(i);
        const glm::dvec3 light = curve.light[index];
        const glm::dvec3 variance = curve.variance[index];
        series.weight[i] = 1.0 / std::sqrt(variance.r + variance.g + variance.b);
        series.light[i] = (light.r + light.g + light.b) * series.weight[i];
    }
    return series;
}

Vector exponential(const Series& series, double seconds) {
    Vector values(series.weight.size());
    for (Eigen::Index i = 0; i < values.size(); ++i)
        values[i] = std::exp(-static_cast<double>(i) * series.frame / seconds) * series.weight[i];
    return values;
}

// Times, their amounts and the background.
struct Exponentials {
    std::vector<double> seconds;
    Vector amounts;                                         // the background is last
    double cost = std::numeric_limits<double>::infinity();  // sum of squared residuals
};

// The best amounts for these times; nullopt: one of them is negative.
std::optional<Exponentials> with_amounts(const Series& series, std::vector<double> seconds) {
    const auto count = static_cast<Eigen::Index>(seconds.size());
    Matrix basis(series.weight.size(), count + 1);
    for (Eigen::Index i = 0; i < count; ++i)
        basis.col(i) = exponential(series, seconds[static_cast<std::size_t>(i)]);
    basis.col(count) = series.weight;
    const Vector amounts =
        (basis.transpose() * basis).ldlt().solve(basis.transpose() * series.light);
    if ((amounts.head(count).array() <= 0.0).any())
        return std::nullopt;
    const double cost = (series.light - basis * amounts).squaredNorm();
    return Exponentials{std::move(seconds), amounts, cost};
}

std::vector<double> grid_of(const Series& series) {
    constexpr int count = 32;
    const double low = series.frame / 3.0;
    const double high = 2.0 * series.frame * static_cast<double>(series.weight.size());
    std::vector<double> grid;
    for (int i = 0; i < count; ++i)
        grid.push_back(low * std::pow(high / low, i / (count - 1.0)));
    return grid;
}

// The best of all combinations on the grid that begin with `chosen`.
void search(const Series& series, const std::vector<double>& grid, std::size_t from,
            std::size_t more, std::vector<double>& chosen, Exponentials& best) {
    if (more == 0) {
        if (const auto found = with_amounts(series, chosen); found && found->cost < best.cost)
            best = *found;
        return;
    }
    for (std::size_t i = from; i < grid.size(); ++i) {
        chosen.push_back(grid[i]);
        search(series, grid, i + 2, more - 1, chosen, best);
        chosen.pop_back();
    }
}

// The derivatives by the logarithms of the times, the amounts and the background.
Matrix slopes_of(const Series& series, const Exponentials& at) {
    const auto count = static_cast<Eigen::Index>(at.seconds.size());
    Matrix slopes(series.weight.size(), 2 * count + 1);
    for (Eigen::Index i = 0; i < count; ++i) {
        const double seconds = at.seconds[static_cast<std::size_t>(i)];
        const Vector values = exponential(series, seconds);
        slopes.col(count + i) = values;
        for (Eigen::Index frame = 0; frame < values.size(); ++frame)
            slopes(frame, i) =
                at.amounts[i] * values[frame] * static_cast<double>(frame) * series.frame / seconds;
    }
    slopes.col(2 * count) = series.weight;
    return slopes;
}

// Gauss-Newton for the times; the amounts are solved for each.
void refine(const Series& series, Exponentials& best) {
    constexpr int steps = 30;
    const auto count = static_cast<Eigen::Index>(best.seconds.size());
    for (int step = 0; step < steps; ++step) {
        const Matrix slopes = slopes_of(series, best);
        Vector residuals = series.light;
        for (Eigen::Index i = 0; i < count; ++i)
            residuals -=
                best.amounts[i] * exponential(series, best.seconds[static_cast<std::size_t>(i)]);
        residuals -= best.amounts[count] * series.weight;
        const Vector change =
            (slopes.transpose() * slopes).ldlt().solve(slopes.transpose() * residuals).head(count);
        bool is_better = false;
        for (double share = 1.0; share > 0.05 && !is_better; share *= 0.5) {
            std::vector<double> seconds = best.seconds;
            for (Eigen::Index i = 0; i < count; ++i)
                seconds[static_cast<std::size_t>(i)] *=
                    std::exp(std::clamp(share * change[i], -0.5, 0.5));
            const auto next = with_amounts(series, seconds);
            is_better = next && next->cost < best.cost;
            if (is_better)
                best = *next;
        }
        if (!is_better)
            return;
    }
}

std::string why_not_identifiable(double seconds, double half, double frame) {
    constexpr double share_of_value = 0.5;
    if (seconds < frame)
        return "it is shorter than a frame of the video";
    if (std::exp(half) - 1.0 > share_of_value)
        return "the video hardly shows it";
    return {};
}
}  // namespace

std::vector<TimeConstant> time_constants(const RecordedDecay& recorded) {
    constexpr double normal_90 = 1.6449;
    const Series series = series_of(recorded.curve);
    const auto frames = static_cast<double>(series.weight.size());
    const std::vector<double> grid = grid_of(series);
    Exponentials best;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t count = 1; count <= 3; ++count) {
        Exponentials found;
        std::vector<double> chosen;
        search(series, grid, 0, count, chosen, found);
        if (found.seconds.empty())
            continue;
        refine(series, found);
        const double criterion =
            found.cost + (2.0 * static_cast<double>(count) + 1.0) * std::log(frames);
        if (criterion < least) {
            least = criterion;
            best = std::move(found);
        }
    }
    std::vector<TimeConstant> constants;
    if (best.seconds.empty())
        return constants;
    const Matrix slopes = slopes_of(series, best);
    const auto unknowns = static_cast<double>(slopes.cols());
    const double excess = std::max(1.0, best.cost / std::max(frames - unknowns, 1.0));
    const Matrix covariance = (slopes.transpose() * slopes).inverse() * excess;
    double all = 0.0;
    for (std::size_t i = 0; i < best.seconds.size(); ++i)
        all += best.seconds[i] * best.amounts[static_cast<Eigen::Index>(i)];
    for (std::size_t i = 0; i < best.seconds.size(); ++i) {
        const auto index = static_cast<Eigen::Index>(i);
        const double seconds = best.seconds[i];
        const double variance =
            std::max(covariance(index, index), 0.0) + std::pow(shared_light_error, 2);
        const double half = normal_90 * std::sqrt(variance);  // of the logarithm
        constants.push_back({seconds, seconds * std::exp(-half), seconds * std::exp(half),
                             seconds * best.amounts[index] / all,
                             why_not_identifiable(seconds, half, series.frame)});
    }
    std::ranges::sort(constants, {}, &TimeConstant::seconds);
    return constants;
}
