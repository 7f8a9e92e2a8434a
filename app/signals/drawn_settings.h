#pragma once

#include "signals/points.h"
#include "signals/settings.h"

// What the signals that draw paths have in common.

inline SettingFacts size_setting(double initial, std::string help) {
    return {.key = "size",
            .label = "Size",
            .unit = "half screens",
            .help = std::move(help),
            .low = 0.05,
            .high = 2,
            .initial = initial,
            .limit = {0.001, 100}};
}

inline SettingFacts spin_setting() {
    return {.key = "spin",
            .label = "Spin",
            .unit = "degrees/s",
            .help = "How fast it turns around its upright axis; 0 stands still.",
            .low = -180,
            .high = 180,
            .limit = {-100000, 100000}};
}

inline SettingFacts speed_setting() {
    return {.key = "beam_speed",
            .label = "Beam speed",
            .unit = "half screens/s",
            .help =
                "How fast the beam draws. Slower is brighter, and flickers when it takes more "
                "than 1/60 s.",
            .low = 50,
            .high = 10000,
            .initial = 1000,
            .logarithmic = true,
            .limit = {1, 1e6}};
}

/// Points a second.
inline double rate_of(const Settings& settings) {
    return settings.number("points") * 60.0;
}
