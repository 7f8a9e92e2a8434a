#include "model/photo/beam_profile.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>

namespace {
constexpr int rounds = 3;  // of finding the middle

double distance_of(std::size_t value, double reach) {
    return reach * static_cast<double>(value) / static_cast<double>(BeamProfile::values - 1);
}

// The mean of the positions with at least half of the most light, weighted by what is above it.
// `light`: at positions from -reach to reach.
double middle_of(const std::function<double(double)>& light, double reach) {
    constexpr int count = 321;
    const auto position = [reach](int i) { return reach * (2.0 * i / (count - 1) - 1.0); };
    std::array<double, count> values{};
    for (int i = 0; i < count; ++i)
        values.at(static_cast<std::size_t>(i)) = light(position(i));
    const auto [low, high] = std::ranges::minmax(values);
    const double half = low + 0.5 * (high - low);
    double sum = 0.0;
    double moment = 0.0;
    for (int i = 0; i < count; ++i) {
        const double above = std::max(values.at(static_cast<std::size_t>(i)) - half, 0.0);
        sum += above;
        moment += above * position(i);
    }
    return sum > 0.0 ? moment / sum : 0.0;
}

// The mean light of a piece of a line, at a distance to its left.
double light_of_piece(const LightMap& map, glm::dvec2 middle, glm::dvec2 along, double length,
                      double distance) {
    const glm::dvec2 across(-along.y, along.x);
    const int count = std::max(static_cast<int>(std::ceil(length)), 1);
    double sum = 0.0;
    for (int i = 0; i < count; ++i) {
        const double shift = length * ((i + 0.5) / count - 0.5);
        sum += static_cast<double>(map.at(middle + shift * along + distance * across));
    }
    return sum / count;
}

std::vector<double> line_piece(const LightMap& map, glm::dvec2 middle, glm::dvec2 along,
                               double length, double reach) {
    constexpr double core = 0.3;  // of the reach, in which the middle is
    double centre = 0.0;
    const auto light = [&](double distance) {
        return light_of_piece(map, middle, along, length, centre + distance);
    };
    for (int round = 0; round < rounds; ++round)
        centre += middle_of(light, core * reach);
    std::vector<double> values;
    for (std::size_t i = 0; i < BeamProfile::values; ++i) {
        const double distance = distance_of(i, reach);
        values.push_back(0.5 * (light(distance) + light(-distance)));
    }
    return values;
}

glm::dvec2 middle_of_dot(const LightMap& map, glm::dvec2 at, double reach) {
    constexpr double core = 0.3;
    for (int round = 0; round < rounds; ++round)
        for (const glm::dvec2 axis : {glm::dvec2(1.0, 0.0), glm::dvec2(0.0, 1.0)})
            at += axis * middle_of(
                             [&](double distance) {
                                 return static_cast<double>(map.at(at + distance * axis));
                             },
                             core * reach);
    return at;
}

std::vector<double> dot_sector(const LightMap& map, glm::dvec2 at, std::size_t sector,
                               double reach) {
    constexpr double full = 2.0 * std::numbers::pi;
    constexpr int angles = 8;
    std::vector<double> values;
    for (std::size_t i = 0; i < BeamProfile::values; ++i) {
        double sum = 0.0;
        for (int k = 0; k < angles; ++k) {
            const double angle = full * (static_cast<double>(sector) + (k + 0.5) / angles) /
                                 static_cast<double>(BeamProfile::pieces);
            sum += static_cast<double>(
                map.at(at + distance_of(i, reach) * glm::dvec2(std::cos(angle), std::sin(angle))));
        }
        values.push_back(sum / angles);
    }
    return values;
}
}  // namespace

std::vector<double> BeamProfile::mean() const {
    std::vector<double> sum(values, 0.0);
    for (const auto& piece : light)
        for (std::size_t i = 0; i < values; ++i)
            sum[i] += piece[i] / static_cast<double>(light.size());
    return sum;
}

BeamProfile beam_profile(const LightMap& map, const BeamPlace& place, double reach) {
    BeamProfile profile;
    const glm::dvec2 middle = place.is_line() ? place.at : middle_of_dot(map, place.at, reach);
    const double length = 2.0 * reach / static_cast<double>(BeamProfile::pieces);
    for (std::size_t i = 0; i < BeamProfile::pieces; ++i) {
        const double shift = length * (static_cast<double>(i) + 0.5) - reach;
        profile.light.push_back(place.is_line() ? line_piece(map, middle + shift * place.along,
                                                             place.along, length, reach)
                                                : dot_sector(map, middle, i, reach));
    }
    return profile;
}
