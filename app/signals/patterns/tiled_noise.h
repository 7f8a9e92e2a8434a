#pragma once

#include <array>
#include <cstdint>

/// Value noise that repeats in the unit cube: numbers at the corners of `cells` cells a side,
/// blended smoothly between. 0 to 1.
double tiled_noise(const std::array<double, 3>& place, int cells, std::uint32_t seed);

/// Five octaves of it, from `cells` on, each half as strong as the one before. 0 to 1.
double tiled_fractal_noise(const std::array<double, 3>& place, int cells, std::uint32_t seed);
