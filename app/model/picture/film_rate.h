#pragma once

#include <string>

/// Frames a second as two whole numbers, as films have it: 30000/1001.
struct FilmRate {
    int above = 60;
    int below = 1;

    double number() const { return static_cast<double>(above) / below; }
    /// "30000/1001" with '/' between.
    std::string text(char between) const {
        return std::to_string(above) + between + std::to_string(below);
    }
};

/// With the smallest number below that comes within a thousand millionth of it; up to 1000 a
/// second.
FilmRate film_rate_of(double fps);
