#pragma once

#include "base/diagnostic.h"
#include "model/look/look.h"

#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// A parameter and its sequence of values.
struct SweepAxis {
    struct Stop {
        Value value;
        std::string caption;  // "Decay 0.92 per 1/60 s"
    };

    std::string parameter;
    std::vector<Stop> stops;
};

/// Parses "decay=0.5:0.99:5", five values spread evenly along the slider, or a list
/// "tone_map=Clamp,ACES". A logarithmic slider with both ends above 0 has equal ratios. Values of
/// integer parameters are rounded. Fails for parameters that are not a single number, and outside
/// their limits.
Result<SweepAxis> parse_sweep_axis(std::string_view text, const Look& look);

/// One picture of a sweep: its values and its caption.
struct SweepCell {
    std::vector<std::pair<std::string, Value>> values;
    std::string caption;
};

/// All combinations; the first axis varies fastest.
std::vector<SweepCell> sweep_cells(const std::vector<SweepAxis>& axes);

/// The columns of a sheet with one axis.
inline constexpr int usual_sheet_columns = 5;
/// The columns of the sheet of a sweep: with two axes, the first one goes across.
int sheet_columns(const std::vector<SweepAxis>& axes, int with_one_axis = usual_sheet_columns);
