#pragma once

#include <array>
#include <cmath>
#include <string>

/// A line of Tektronix, "CRT Data", phosphor decay table, rev. A, 1966: milliseconds to 10, 1 and
/// 0.1 %, and the luminance relative to P31 at 100.
struct MeasuredLine {
    const char* name;
    double item;
    std::array<double, 3> milliseconds;
    double luminance;
};

inline constexpr std::array<MeasuredLine, 10> measured{{{"P1", 1, {27, 60, 95}, 45},
                                                        {"P2", 2, {0.37, 4.7, 51}, 60},
                                                        {"P3", 3, {19, 45, 74}, 45},
                                                        {"P4", 4, {0.32, 3.3, 20}, 50},
                                                        {"P7", 5, {0.305, 5.7, 66}, 45},
                                                        {"P11", 6, {0.274, 2.6, 17}, 25},
                                                        {"P14", 7, {0.44, 6.7, 55}, 40},
                                                        {"P28", 8, {0.39, 17, 132.5}, 50},
                                                        {"P31", 9, {0.34, 4.5, 32}, 100},
                                                        {"P32", 10, {1, 18, 235}, 25}}};
/// I(t) = sum of weight e^(-t / seconds).
struct Decay {
    std::array<double, 3> weights{};
    std::array<double, 3> seconds{1, 1, 1};

    double light() const { return light_until(1e9); }
    double light_until(double time) const {
        double sum = 0;
        for (std::size_t i = 0; i < 3; ++i)
            sum += weights[i] * seconds[i] * -std::expm1(-time / seconds[i]);
        return sum;
    }
};

// Two terms through the three points; the fast one is almost zero at the second.
inline Decay solved_for_silicate(const std::array<double, 3>& times) {
    Decay d{{0.5, 0.5, 0}, {times[0] / 3.6, times[2] / 7, 1}};
    for (int i = 0; i < 1000; ++i) {
        const double one = 0.01 - d.weights[0] * std::exp(-times[1] / d.seconds[0]);
        const double tenth = 0.001 - d.weights[0] * std::exp(-times[2] / d.seconds[0]);
        d.seconds[1] = (times[2] - times[1]) / std::log(one / tenth);
        d.weights[1] = one * std::exp(times[1] / d.seconds[1]);
        d.weights[0] = 1 - d.weights[1];
        d.seconds[0] =
            -times[0] /
            std::log((0.1 - d.weights[1] * std::exp(-times[0] / d.seconds[1])) / d.weights[0]);
    }
    return d;
}

// The time constants of the slow terms are half the times to 1 and 0.1 %.
inline Decay solved_for_sulphide(const std::array<double, 3>& times) {
    Decay d{{0.96, 0.03, 0.007}, {times[0] / 2.4, times[1] / 2, times[2] / 2}};
    const auto left = [&](std::size_t term, double time) {
        return d.weights[term] * std::exp(-time / d.seconds[term]);
    };
    for (int i = 0; i < 1000; ++i) {
        d.weights[2] = (0.001 - left(0, times[2]) - left(1, times[2])) * std::exp(2);
        d.weights[1] = (0.01 - left(0, times[1]) - left(2, times[1])) * std::exp(2);
        d.weights[0] = 1 - d.weights[1] - d.weights[2];
        d.seconds[0] =
            -times[0] / std::log((0.1 - left(1, times[0]) - left(2, times[0])) / d.weights[0]);
    }
    return d;
}

inline Decay solved(const MeasuredLine& tube) {
    std::array<double, 3> seconds = tube.milliseconds;
    for (double& time : seconds)
        time *= 0.001;
    const std::string name = tube.name;
    return name == "P1" || name == "P3" ? solved_for_silicate(seconds)
                                        : solved_for_sulphide(seconds);
}
