#include "signals/generators/shape.h"

#include "signals/signal/sine.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <numbers>

namespace {
struct NamedShape {
    std::string_view name;
    Shape shape;
};

constexpr std::array<NamedShape, 6> named_shapes{{{"sine", Shape::sine},
                                                  {"triangle", Shape::triangle},
                                                  {"square", Shape::square},
                                                  {"saw", Shape::saw},
                                                  {"noise", Shape::noise},
                                                  {"off", Shape::off}}};

// A pseudo-random number in -1 .. 1 (the finaliser of SplitMix64, Steele et al. 2014).
double random_level(std::int64_t index, std::uint64_t seed) {
    std::uint64_t bits = static_cast<std::uint64_t>(index) + seed * 0x9e3779b97f4a7c15u;
    bits = (bits ^ (bits >> 30)) * 0xbf58476d1ce4e5b9u;
    bits = (bits ^ (bits >> 27)) * 0x94d049bb133111ebu;
    bits ^= bits >> 31;
    return static_cast<double>(bits >> 11) * 0x1.0p-52 - 1.0;
}

double noise(double turns, std::uint64_t seed) {
    constexpr double levels_per_turn = 32.0;
    const double position = turns * levels_per_turn;
    const double below = std::floor(position);
    const auto index = static_cast<std::int64_t>(below);
    return std::lerp(random_level(index, seed), random_level(index + 1, seed), position - below);
}
}  // namespace

std::vector<std::string> shape_names() {
    std::vector<std::string> names;
    names.reserve(named_shapes.size());
    for (const NamedShape& shape : named_shapes)
        names.emplace_back(shape.name);
    return names;
}

Shape shape_named(std::string_view name) {
    const auto found = std::find_if(named_shapes.begin(), named_shapes.end(),
                                    [&](const NamedShape& shape) { return shape.name == name; });
    assert(found != named_shapes.end());
    return found->shape;
}

double wave(Shape shape, double turns, std::uint64_t seed) {
    switch (shape) {
        case Shape::sine:
            return sine(turns);
        case Shape::triangle:
            return 1.0 - 4.0 * std::abs(fraction(turns + 0.25) - 0.5);
        case Shape::square:
            return fraction(turns) < 0.5 ? 1.0 : -1.0;
        case Shape::saw:
            return 2.0 * fraction(turns + 0.5) - 1.0;
        case Shape::noise:
            return noise(turns, seed);
        case Shape::off:
            break;
    }
    return 0.0;
}

std::optional<double> crossing(Shape shape, double level, bool is_rising) {
    if (shape == Shape::off || std::abs(level) >= 1.0)
        return std::nullopt;
    switch (shape) {
        case Shape::sine: {
            const double turns = std::asin(level) / (2.0 * std::numbers::pi);
            return fraction(is_rising ? turns : 0.5 - turns);
        }
        case Shape::triangle:
            return fraction(is_rising ? 0.25 * level : 0.5 - 0.25 * level);
        case Shape::square:
            return is_rising ? 0.0 : 0.5;
        case Shape::saw:
            return is_rising ? fraction(0.5 * level) : 0.5;
        case Shape::noise:
        case Shape::off:
            break;
    }
    return 0.0;
}
