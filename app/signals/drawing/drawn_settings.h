#pragma once

#include "signals/signal/points.h"
#include "signals/signal/settings.h"

// Settings shared by the signals that draw paths.

inline SettingInfo size_setting(double initial, std::string help) {
    return {.key = "size",
            .label = "Size",
            .unit = "half screens",
            .help = std::move(help),
            .low = 0.05,
            .high = 2,
            .initial = initial,
            .limit = {0.001, 100}};
}

inline SettingInfo spin_setting() {
    return {.key = "spin",
            .label = "Spin",
            .unit = "°/s",
            .help = "Speed of rotation about the vertical axis. 0 stops it.",
            .low = -180,
            .high = 180,
            .limit = {-100000, 100000}};
}

inline SettingInfo speed_setting() {
    return {.key = "beam_speed",
            .label = "Beam speed",
            .unit = "half screens/s",
            .help =
                "Drawing speed of the beam. Slower is brighter, but flickers if a drawing takes "
                "more than 1/60 s.",
            .low = 50,
            .high = 10000,
            .initial = 1000,
            .logarithmic = true,
            .limit = {1, 1e6}};
}

/// Points per second.
inline double rate_of(const Settings& settings) {
    return settings.number("points") * 60.0;
}
