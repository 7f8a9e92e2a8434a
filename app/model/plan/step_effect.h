#pragma once

#include "model/look/look.h"

#include <optional>
#include <string>
#include <vector>

/// How far a pass that was drawn with another value is from itself, number by number; NaN against a
/// number is infinitely far.
struct PassChange {
    double mean = 0.0;     // of the absolute differences
    double largest = 0.0;  // of them
    double level = 0.0;    // mean of the absolute numbers that are compared with

    bool operator==(const PassChange&) const = default;
    bool has_changed() const { return largest > 0.0; }
};

/// The mean difference in shares of the level; 1 where something comes out of nothing, and at most.
double change_share(const PassChange& change);

/// Where that lies on a bar, 0..1: in equal ratios from a hundredth of a per cent to all.
double change_place(const PassChange& change);

/// What became of a change of one parameter on its way through the passes.
struct StepEffect {
    enum class Kind {
        seen,   // in the picture
        faint,  // there too, but by less than half of one of a display's 255 levels
        lost,   // some passes change, the picture does not
        none,   // no pass changes
    };

    Kind kind = Kind::none;
    /// Where it ends when the picture does not change: those that use the parameter, or read what
    /// has changed, and yet draw the same.
    std::vector<std::string> ends = {};
    /// The last pass that changes; "": none.
    std::string last_changed = {};

    bool operator==(const StepEffect&) const = default;
};

/// `changes` of all passes in order; the last one's are of what a display shows, 0..1.
StepEffect effect_of(const Look& look, const Parameter& parameter,
                     const std::vector<PassChange>& changes);

/// "changes the picture by up to 14 of 255 levels, 0.8 on average", or where it ends.
std::string effect_text(const StepEffect& effect, const PassChange& picture);
