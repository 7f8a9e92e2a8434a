#pragma once

#include "model/look/picture.h"

#include <vector>

/// The direction in which a pattern repeats.
enum class Along { rows, columns };

/// The power of a picture's patterns by frequency.
struct PeriodSpectrum {
    double step = 1.0;          // cycles per px from one entry to the next
    std::vector<double> power;  // mean of all lines
};

/// The spectrum of the middle of a picture, where curved glass varies periods least, in one
/// direction: of red minus blue along rows, which shows a mask's colours, and of luma along
/// columns, which shows scanlines. `picture`: 3 channels as in SampleValues.
PeriodSpectrum period_spectrum(const Picture& picture, Along along);

/// The periods, px, with the highest power. The strongest comes first; at most `count`.
std::vector<double> peak_periods(const PeriodSpectrum& spectrum, double shortest, double longest,
                                 std::size_t count);

/// The periods of a pattern in one spectrum divided by those in another, 0.9 to 1.1: the ratio that
/// makes both most alike around a period, px. Also right if periods vary over the picture.
double period_ratio(const PeriodSpectrum& one, const PeriodSpectrum& other, double period);
