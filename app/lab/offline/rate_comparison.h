#pragma once

#include "base/work.h"
#include "lab/document/document.h"
#include "model/picture/difference.h"

#include <array>
#include <vector>

/// Frames a second that a look ought to look the same at.
inline constexpr std::array compared_rates{24.0, 30.0, 60.0, 144.0};

/// How far the pictures of two frame rates are apart, in display values.
struct RatePair {
    double first = 0.0;  // frames a second
    double second = 0.0;
    Difference difference;
};

/// The pictures that all rates draw of the same moment, against each other.
struct RateComparison {
    double seconds = 0.0;  // the moment, from a fresh start
    Extent size;
    std::vector<RatePair> pairs;    // every two of compared_rates
    std::vector<Picture> pictures;  // of each of compared_rates, as a display shows it

    /// The pair that is farthest apart: its place in `pairs`.
    std::size_t worst_place() const;
    const RatePair& worst() const { return pairs[worst_place()]; }
    /// Of one of compared_rates.
    const Picture& picture(double fps) const;
};

/// When a look has settled and every one of compared_rates ends a frame: a multiple of 1/6 s.
double moment_to_compare(const Look& look);

/// The size that is drawn for a picture: at most 360 lines, as every frame is drawn.
Extent size_to_compare(Extent picture);

/// Draws a document at every rate from a fresh start up to moment_to_compare, with a GL context of
/// its own. Fails where it cannot be drawn, where what drives it comes but once (a microphone), and
/// when it is cancelled.
Result<RateComparison> compare_rates(const Document& document, Extent picture, Work& work);
