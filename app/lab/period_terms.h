#pragma once

#include "model/aliasing.h"

class Document;
class Renderer;

/// What the period of a parameter depends on in the open look. `renderer` may be null: nothing is
/// drawn yet.
PeriodTerms period_terms(const Parameter& parameter, const Document& document,
                         const Renderer* renderer);

/// What is told of a parameter that sets a period.
struct PeriodFacts {
    std::optional<double> period;  // px; none: it sets none now
    std::optional<double> beat;    // px from one band of moiré to the next; none: none is seen
    bool is_too_fine = false;      // below 2 px, which no pixels can show
    std::optional<double> even;    // the nearest value with neither
};
PeriodFacts period_facts(const Parameter& parameter, double value, const PeriodTerms& terms);
