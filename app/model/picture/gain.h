#pragma once

#include "model/look/look.h"
#include "model/picture/statistics.h"

#include <optional>

/// The level of a target, relative to the largest value that it can show.
struct TargetLevel {
    double peak = 0.0;
    double mean = 0.0;
    double ceiling = 1.0;
    double clipped = 0.0;  // fraction of texels at or above the ceiling

    bool operator==(const TargetLevel&) const = default;
};

/// `clipped` of the measured texels were at the ceiling.
TargetLevel target_level_of(const Statistics& statistics, std::size_t clipped, double ceiling);

/// How much the peak may still grow, in stops; nullopt without light.
std::optional<double> headroom_stops(const TargetLevel& gain);

/// The largest finite value of a format.
double format_limit(Format format);

/// The clipping level of a pass: its parameter `ceiling`, otherwise the limit of its format. If
/// passes with this parameter read their own last frame, only the last of them clips at it. The
/// others only use the value.
double ceiling_of(const Look& look, std::size_t pass, const Values& values);

/// The smallest value that counts as clipped: half floats have eleven significant bits.
double clips_from(double ceiling);

/// The position of a number on a meter that covers this many stops below the ceiling: 0..1.
inline constexpr double meter_stops = 16.0;
double meter_ratio(double number, double ceiling);
