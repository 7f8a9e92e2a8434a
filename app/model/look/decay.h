#pragma once

#include "model/look/parameter.h"

#include <optional>
#include <string>
#include <string_view>

// A light that fades by the same factor every sixtieth of a second: left after t seconds is
// factor^(60 t). Half is left after h seconds where factor = 2^(-1 / (60 h)).

/// Whether a parameter is such a factor: a number up to 1 with the unit "per 1/60 s".
bool is_decay(const Parameter& parameter);

/// Seconds until `share` of the light is left; 0 for a factor of 0 or less, infinite from 1 on.
double seconds_to(double share, double factor);
inline double half_life(double factor) {
    return seconds_to(0.5, factor);
}

/// The factor with which `share` (0..1, both left out) is left after `seconds` (above 0).
double factor_leaving(double share, double seconds);

/// Reads "120 ms" and "0.5 s", a half-life, and "10% 0.4 s", what is left and when; a comma may
/// stand for the point. None where the text says no such thing.
std::optional<double> parse_decay(std::string_view text);

/// "139 ms", "1.4 s": three digits or fewer; "forever" where it is infinite.
std::string duration_text(double seconds);
