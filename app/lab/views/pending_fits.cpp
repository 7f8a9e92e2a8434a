#include "lab/views/pending_fits.h"

#include "lab/lab.h"

#include <algorithm>
#include <cmath>

std::optional<double> fitting_gain(const Comparison& comparison,
                                   const std::optional<Distances>& distances) {
    if (!distances || !(distances->largest > 0.0) || !std::isfinite(distances->largest) ||
        comparison.measure == DifferenceMeasure::relative)
        return std::nullopt;
    const double stops = -std::log2(distances->largest);
    const bool is_squared = comparison.measure == DifferenceMeasure::squared;
    return std::clamp(is_squared ? 2.0 * stops : stops, -4.0, 16.0);
}

namespace {
void fit_levels(const Views& views, WindowState& window) {
    const bool is_measured = window.layout.sees(panel_id::inspector);
    if (const auto statistics = views.inspector().statistics(); is_measured && statistics)
        window.views.inspected.fit(*statistics);
    else if (is_measured)
        return;
    window.views.pending.levels = false;
}

void fit_gain(const Views& views, Lab& lab, WindowState& window) {
    const ComparedPictures& compared = views.main().compared();
    const auto& distances = compared.distances();
    const bool is_measured = lab.frames().comparison().mode() == CompareMode::difference;
    if (is_measured && !distances)
        return;
    Comparison comparison = lab.frames().comparison().selection().chosen();
    if (const auto gain = fitting_gain(comparison, distances); is_measured && gain) {
        comparison.gain_stops = *gain;
        lab.frames().comparison().choose(comparison);
    }
    window.views.pending.gain = false;
}
}  // namespace

void apply_pending_fits(const Views& views, Lab& lab, WindowState& window) {
    if (window.views.pending.levels)
        fit_levels(views, window);
    if (window.views.pending.gain)
        fit_gain(views, lab, window);
}
