#pragma once

#include <array>
#include <cstdint>

/// Value noise that repeats in the unit cube: random values at the corners of `cells` cells per
/// side, smoothly interpolated. 0 to 1.
double tiled_noise(const std::array<double, 3>& position, int cells, std::uint32_t seed);

/// Five octaves of it, starting at `cells`, each with half the previous amplitude. 0 to 1.
double tiled_fractal_noise(const std::array<double, 3>& position, int cells, std::uint32_t seed);
