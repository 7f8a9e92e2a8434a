#pragma once

#include "model/look/look.h"

#include <optional>
#include <string>
#include <vector>

/// The difference between a pass drawn with another value and the original, number by number. NaN
/// against a number is infinite.
struct PassChange {
    double mean = 0.0;     // of the absolute differences
    double largest = 0.0;  // of the absolute differences
    double level = 0.0;    // mean of the absolute original values

    bool operator==(const PassChange&) const = default;
    bool has_changed() const { return largest > 0.0; }
};

/// The mean difference relative to the level; at most 1, which is also the result for a level of 0.
double change_share(const PassChange& change);

/// The position of this share on a bar, 0..1, logarithmic from 0.01 % to 100 %.
double change_ratio(const PassChange& change);

/// The effect of a change of one parameter on the passes.
struct StepEffect {
    enum class Kind {
        seen,   // in the picture
        faint,  // in the picture, but by less than half of one of a display's 255 levels
        lost,   // some passes change, but the picture does not
        none,   // no pass changes
    };

    Kind kind = Kind::none;
    /// Where the effect ends if the picture does not change: passes that use the parameter or read
    /// a changed pass, but draw the same.
    std::vector<std::string> ends = {};
    /// The last pass that changes; "" if none does.
    std::string last_changed = {};

    bool operator==(const StepEffect&) const = default;
};

/// `changes` of all passes in order; those of the last pass are display values, 0..1.
StepEffect effect_of(const Look& look, const Parameter& parameter,
                     const std::vector<PassChange>& changes);

/// "changes the picture by up to 14 of 255 levels, 0.8 on average", or where the effect ends.
std::string effect_text(const StepEffect& effect, const PassChange& picture);
