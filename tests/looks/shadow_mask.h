#pragma once

#include "looks/drawn_picture.h"

#include <doctest/doctest.h>

namespace shadow_mask {
inline Value point(double x, double y) {
    return Value(std::vector<double>{x, y});
}

/// Each stage switched off separately: a plain copy.
inline Values stages_off() {
    return {{"mask_strength", Value(0.0)},   {"sampling", Value(2.0)},
            {"red_offset", point(0, 0)},     {"green_offset", point(0, 0)},
            {"blue_offset", point(0, 0)},    {"curvature", Value(0.0)},
            {"vignette_depth", Value(0.0)},  {"pulse_intensity", Value(0.0)},
            {"bloom_intensity", Value(0.0)}, {"tone_map", Value(6.0)},
            {"corner_radius", Value(0.0)},   {"dither", Value(0.0)}};
}

inline Values with(Values values, const Values& more) {
    for (const auto& [name, value] : more)
        values[name] = value;
    return values;
}

inline double number(const Picture& picture, int x, int y, std::size_t channel = 1) {
    return static_cast<double>(picture.pixels[picture.index(x, y) + channel]);
}
}  // namespace shadow_mask
