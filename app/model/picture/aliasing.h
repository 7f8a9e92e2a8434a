#pragma once

#include "model/look/look.h"
#include "model/picture/source_raster.h"

#include <optional>
#include <string_view>
#include <vector>

// Stripes of period p px that are drawn on pixels: where p is whole each stripe is drawn like the
// one before. Else stripe and pixel drift apart by |1/p - 1/n| of a cycle a px, n being the whole
// number nearest to p, and a pattern comes of it that repeats with the beat of both frequencies
// (I. Amidror, The Theory of the Moire Phenomenon, 2nd ed., section 2.4: the difference of the
// two).

/// Sizes and values that the period of a parameter is computed from.
struct PeriodTerms {
    const Look& look;
    const Values& values;
    Extent target;        // px that the first pass which uses it draws
    SourceRaster raster;  // of what the pass reads as the source
};

/// How many px lie from one stripe to the next that the parameter at `value` sets: by its
/// expression, which may name parameters of its look, WIDTH and HEIGHT (px of the target), LINE (px
/// from one line of the source to the next), LINES (how many there are), COLUMN and COLUMNS;
/// without one a period as it is. None where it sets none.
std::optional<double> period_of(const Parameter& parameter, double value, const PeriodTerms& terms);

/// The value within the parameter's range, near `value`, whose period is the nearest whole number
/// of px. None where no value has it.
std::optional<double> even_value(const Parameter& parameter, double value,
                                 const PeriodTerms& terms);

/// A mistake in the expressions of these parameters at their defaults, at their lines.
Diagnostics check_periods(const std::vector<Parameter>& parameters, const Look& look);

/// How far apart two places of the beat are, in px; infinite for a whole period.
double beat_of(double period);

/// How much stripes differ at most from one another: a pixel is half a px or nearer to each crest
/// of a wave, so the highest one that is drawn of a crest 1 lies between cos(pi / p) and 1.
double unevenness_of(double period);

/// The beat that is seen across `length` px: none where it is longer than that, or where the
/// stripes are even to a twentieth.
std::optional<double> visible_beat(double period, double length);

/// The whole periods between two ends, from 2 px on: what is finer no pixels can show.
std::vector<double> safe_periods(double low, double high);
