#pragma once

#include "model/look/look.h"
#include "model/picture/source_raster.h"

#include <optional>
#include <string_view>
#include <vector>

// Stripes with a period of p px on the pixel grid. If p is an integer, all stripes are drawn alike.
// Otherwise stripes and pixels drift apart by |1/p - 1/n| cycles per px, where n is the integer
// nearest to p. The resulting pattern repeats with the beat of both frequencies (I. Amidror, The
// Theory of the Moire Phenomenon, 2nd ed., section 2.4: the difference of the two).

/// Sizes and values for computing the period of a parameter.
struct PeriodTerms {
    const Look& look;
    const Values& values;
    Extent target;        // px; of the first pass that uses it
    SourceRaster raster;  // of the picture that the pass reads as the source
};

/// The px from one stripe to the next that the parameter sets at `value`. Its expression may use
/// parameters of its look, WIDTH and HEIGHT (px of the target) and the source's raster. LINE is px
/// per source line, LINES the number of source lines; COLUMN and COLUMNS likewise. A period without
/// an expression is the value itself. nullopt for other parameters.
std::optional<double> period_of(const Parameter& parameter, double value, const PeriodTerms& terms);

/// The value in the parameter's range, near `value`, whose period is the nearest integer number of
/// px. nullopt if no value has this period.
std::optional<double> whole_period_value(const Parameter& parameter, double value,
                                         const PeriodTerms& terms);

/// Errors in the period expressions of these parameters at their defaults, with their lines.
Diagnostics check_periods(const std::vector<Parameter>& parameters, const Look& look);

/// The distance between two maxima of the beat, px; infinite for an integer period.
double beat_of(double period);

/// The largest difference between stripes. A pixel is at most half a px from each crest of a wave.
/// The highest drawn value of a crest of 1 is therefore between cos(pi / p) and 1.
double unevenness_of(double period);

/// The beat that is visible across `length` px; nullopt if it is longer, or if stripes differ by
/// less than 1/20.
std::optional<double> visible_beat(double period, double length);

/// The integer periods in a range, from 2 px: pixels can't show finer ones.
std::vector<double> safe_periods(double low, double high);
