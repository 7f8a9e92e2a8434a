#pragma once

#include "base/job_progress.h"
#include "lab/document/document.h"
#include "model/picture/difference.h"

#include <array>
#include <vector>

/// The frame rates at which a look should look the same.
inline constexpr std::array compared_rates{24.0, 30.0, 60.0, 144.0};

/// The difference between two frame rates, in display values.
struct RatePair {
    double first = 0.0;  // frames/s
    double second = 0.0;
    Difference difference;
};

/// The pictures of all frame rates at the same time, and their differences.
struct RateComparison {
    double seconds = 0.0;  // time since the fresh start
    Extent size;
    std::vector<RatePair> pairs;    // all pairs of compared_rates
    std::vector<Picture> pictures;  // for each of compared_rates, display-encoded

    /// The index in `pairs` of the pair with the largest difference.
    std::size_t worst_index() const;
    const RatePair& worst() const { return pairs[worst_index()]; }
    /// For one of compared_rates.
    const Picture& picture(double fps) const;
};

/// The earliest time, a multiple of 1/6 s, at which every rate ends a frame and transients are
/// over.
double comparison_seconds(const Look& look);

/// The size to draw: at most 360 lines, because every frame is drawn.
Extent size_to_compare(Extent picture);

/// Draws a document at every rate from a fresh start up to comparison_seconds(), in its own GL
/// context. Fails if it cannot be drawn, if its input is live, and when cancelled.
Result<RateComparison> compare_rates(const Document& document, Extent picture, JobProgress& work);
