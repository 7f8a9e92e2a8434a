#pragma once

#include "model/picture/gain.h"
#include "model/plan/plan.h"
#include "model/plan/step_effect.h"

#include <string>

/// The texts of a pass in the strip.
namespace strip_text {
/// "640×480 rgba16f".
std::string info(const PlannedTarget& target);
/// Of a pyramid, from its first to its last level: "320×240 to 5×4".
std::string info(const PlannedTarget& first, const PlannedTarget& last);
/// "1.25 ms"; "": unknown. At most as wide as "00.00 ms".
std::string time(double milliseconds);
bool is_clipped(const TargetLevel& gain);
/// The most important value that fits.
std::string gain(const TargetLevel& gain, bool is_narrow);
/// All values, one per line.
std::string gain_help(const TargetLevel& gain);
/// The amount of the change, or a text for no change.
std::string change(const PassChange& change, bool is_narrow);
}  // namespace strip_text
