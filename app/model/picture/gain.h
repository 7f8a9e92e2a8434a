#pragma once

#include "model/look/look.h"
#include "model/picture/statistics.h"

#include <optional>

/// How loud a target is, against the largest number that it can show.
struct Gain {
    double peak = 0.0;
    double mean = 0.0;
    double ceiling = 1.0;
    double clipped = 0.0;  // share of the texels that are at the ceiling or above

    bool operator==(const Gain&) const = default;
};

/// `clipped` texels of those that were measured were at the ceiling.
Gain gain_of(const Statistics& statistics, std::size_t clipped, double ceiling);

/// How far the peak may still grow, in doublings; none where there is no light at all.
std::optional<double> headroom_stops(const Gain& gain);

/// The largest finite number that a format holds.
double format_limit(Format format);

/// Where a pass clips: at the parameter `ceiling` where it has one, else at the limit of its
/// format. Where passes that have it read their own last frame, it is the last of those that the
/// ceiling limits; the others only reckon with it.
double ceiling_of(const Look& look, std::size_t pass, const Values& values);

/// The least number that counts as clipped: half floats keep eleven binary digits.
double clips_from(double ceiling);

/// Where a number stands on a meter that reaches so many stops down from the ceiling: 0..1.
inline constexpr double meter_stops = 16.0;
double meter_place(double number, double ceiling);
