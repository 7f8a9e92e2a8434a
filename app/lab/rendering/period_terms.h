#pragma once

#include "model/picture/aliasing.h"

class Document;
class Renderer;

/// Sizes and values in the open look that the period of a parameter is computed from. `renderer`
/// may be null: nothing is drawn yet.
PeriodTerms period_terms(const Parameter& parameter, const Document& document,
                         const Renderer* renderer);

/// The period that a parameter sets, and whether pixels can draw it evenly.
struct PeriodFacts {
    std::optional<double> period;  // px; none: it sets none now
    std::optional<double> beat;    // px from one band of moiré to the next; none: none is seen
    bool is_too_fine = false;      // below 2 px, which no pixels can show
    std::optional<double> even;    // the nearest value with neither
};
PeriodFacts period_facts(const Parameter& parameter, double value, const PeriodTerms& terms);
