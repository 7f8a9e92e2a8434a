#pragma once

#include "base/diagnostic.h"
#include "model/look/look.h"

#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// One parameter and the values that it takes in turn.
struct SweepAxis {
    struct Stop {
        Value value;
        std::string caption;  // "Decay 0.92 per 1/60 s"
    };

    std::string parameter;
    std::vector<Stop> stops;
};

/// From "decay=0.5:0.99:5", five values spread evenly along the slider (in equal ratios where that
/// is logarithmic and both ends are above 0; to the nearest whole one of a whole number), or from
/// "tone_map=Clamp,ACES", a list. Fails for parameters that are not a single number, and beyond
/// their limits.
Result<SweepAxis> parse_sweep_axis(std::string_view text, const Look& look);

/// One picture of a sweep: what to set, and what it is called.
struct SweepCell {
    std::vector<std::pair<std::string, Value>> values;
    std::string caption;
};

/// Every combination; the first axis runs fastest.
std::vector<SweepCell> sweep_cells(const std::vector<SweepAxis>& axes);
