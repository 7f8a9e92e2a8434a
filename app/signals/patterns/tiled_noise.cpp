#include "signals/patterns/tiled_noise.h"

#include "signals/patterns/hash.h"

#include <cmath>

namespace {
struct Along {
    std::uint32_t before;
    std::uint32_t after;
    double share;  // weight of `after`
};

Along cell_along(double position, int cells) {
    const double at = (position - std::floor(position)) * cells;
    const int cell = static_cast<int>(at) % cells;
    const double rest = at - std::floor(at);
    return {static_cast<std::uint32_t>(cell), static_cast<std::uint32_t>((cell + 1) % cells),
            rest * rest * (3.0 - 2.0 * rest)};
}
}  // namespace

double tiled_noise(const std::array<double, 3>& position, int cells, std::uint32_t seed) {
    const Along x = cell_along(position[0], cells);
    const Along y = cell_along(position[1], cells);
    const Along z = cell_along(position[2], cells);
    const auto corner = [&](std::uint32_t cx, std::uint32_t cy, std::uint32_t cz) {
        return hash_to_unit(cx, cy, hash_of(cz, seed));
    };
    const auto row = [&](std::uint32_t cy, std::uint32_t cz) {
        return std::lerp(corner(x.before, cy, cz), corner(x.after, cy, cz), x.share);
    };
    const auto slice = [&](std::uint32_t cz) {
        return std::lerp(row(y.before, cz), row(y.after, cz), y.share);
    };
    return std::lerp(slice(z.before), slice(z.after), z.share);
}

double tiled_fractal_noise(const std::array<double, 3>& position, int cells, std::uint32_t seed) {
    constexpr int octaves = 5;
    double sum = 0.0;
    double strength = 0.5;
    double whole = 0.0;
    for (int octave = 0; octave < octaves; ++octave, strength /= 2.0) {
        sum += strength *
               tiled_noise(position, cells << octave, seed + static_cast<std::uint32_t>(octave));
        whole += strength;
    }
    return sum / whole;
}
