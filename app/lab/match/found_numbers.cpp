#include "lab/match/found_numbers.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace {
std::string name_of(const Unknown& unknown) {
    return unknown.part == Unknown::Part::look ? fmt::format("'{}'", unknown.parameter)
                                               : camera_part_name(unknown.part);
}

// The unknown whose errors correlate most with those of another one.
struct Alike {
    std::size_t index;
    double correlation;
};

Alike most_alike(std::size_t index, std::size_t count, const std::vector<double>& covariance) {
    Alike most{index, 0.0};
    for (std::size_t i = 0; i < count; ++i) {
        const double product = covariance[index * count + index] * covariance[i * count + i];
        const double correlation =
            product > 0.0 ? std::abs(covariance[index * count + i]) / std::sqrt(product) : 0.0;
        if (i != index && correlation > most.correlation)
            most = {i, correlation};
    }
    return most;
}

// "": it is identifiable. `half`: half the interval.
std::string why_not_identifiable(std::size_t index, double value, double half,
                                 const std::vector<Unknown>& unknowns,
                                 const std::vector<double>& covariance) {
    constexpr double share_of_value = 0.5;
    constexpr double share_of_range = 0.02;
    constexpr double alike = 0.7;
    const Unknown& unknown = unknowns[index];
    const double range = unknown.high - unknown.low;
    if (value <= unknown.low + 1e-6 * range || value >= unknown.high - 1e-6 * range)
        return "the best value is at the end of the slider's range";
    if (half <= std::max(share_of_value * std::abs(value), share_of_range * range))
        return {};
    const Alike other = most_alike(index, unknowns.size(), covariance);
    if (other.correlation < alike)
        return "the photo hardly shows it";
    return fmt::format("the photo can't tell it from {}", name_of(unknowns[other.index]));
}
}  // namespace

std::vector<FoundNumber> found_numbers(const std::vector<Unknown>& unknowns,
                                       const MatchState& state,
                                       const std::vector<double>& covariance) {
    constexpr double normal_90 = 1.6449;
    std::vector<FoundNumber> numbers;
    for (std::size_t i = 0; i < unknowns.size(); ++i) {
        if (unknowns[i].part != Unknown::Part::look)
            continue;
        const double variance = covariance[i * unknowns.size() + i];
        const double half =
            normal_90 * unknowns[i].interval_scale * std::sqrt(std::max(variance, 0.0));
        const double value = unknowns[i].of(state);
        numbers.push_back({unknowns[i].parameter, unknowns[i].index, value,
                           std::max(value - half, unknowns[i].low),
                           std::min(value + half, unknowns[i].high),
                           why_not_identifiable(i, value, half, unknowns, covariance)});
    }
    return numbers;
}
