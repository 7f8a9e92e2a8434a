#pragma once

#include "model/look/parameter.h"

#include <optional>
#include <string>
#include <string_view>

// Light that decays by a constant factor per 1/60 s: after t seconds factor^(60 t) is left. The
// half-life is h seconds if factor = 2^(-1 / (60 h)).

/// Whether a parameter can be such a factor: a slider with a float from 0 to at most 1.
bool can_be_decay(const Parameter& parameter);

/// Whether it is one: its unit is "per 1/60 s", or its scale is the half-life.
bool is_decay(const Parameter& parameter);

/// Seconds until `share` of the light is left; 0 for a factor of at most 0, infinite for at least
/// 1.
double seconds_to(double share, double factor);
inline double half_life(double factor) {
    return seconds_to(0.5, factor);
}

/// The factor for which `share` (0..1, exclusive) is left after `seconds` (above 0).
double factor_leaving(double share, double seconds);

/// Parses a half-life ("120 ms", "0.5 s") or a remaining share and its time ("10% 0.4 s"). Accepts
/// a decimal comma. nullopt for other text.
std::optional<double> parse_decay(std::string_view text);

/// "139 ms", "1.4 s": at most three digits; "forever" if infinite.
std::string duration_text(double seconds);
