#pragma once

#include "model/picture/gain.h"
#include "model/plan/plan.h"
#include "model/plan/step_effect.h"

#include <string>

/// What the strip of passes says of a pass.
namespace strip_words {
/// "640×480 rgba16f".
std::string facts(const PlannedTarget& target);
/// Of a pyramid from its first level to its last: "320×240 to 5×4".
std::string facts(const PlannedTarget& first, const PlannedTarget& last);
/// "1.25 ms"; "" where nothing is known. "00.00 ms" is room for all.
std::string time(double milliseconds);
bool is_clipped(const Gain& gain);
/// What counts most, in the room there is.
std::string gain(const Gain& gain, bool is_narrow);
/// All of it, in lines of their own.
std::string gain_help(const Gain& gain);
/// By how much, and a word where not at all.
std::string change(const PassChange& change, bool is_narrow);
}  // namespace strip_words
