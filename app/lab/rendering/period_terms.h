#pragma once

#include "model/picture/aliasing.h"

class Document;
class Renderer;

/// The sizes and values in the open look that the period of a parameter is computed from.
/// `renderer` may be null: nothing is drawn yet.
PeriodTerms period_terms(const Parameter& parameter, const Document& document,
                         const Renderer* renderer);

/// The period that a parameter sets, and whether pixels can draw it evenly.
struct PeriodInfo {
    std::optional<double> period;  // px; nullopt: no period at this value
    std::optional<double> beat;    // px from one band of moiré to the next; nullopt: not visible
    bool is_too_fine = false;      // below 2 px, which pixels cannot show
    std::optional<double> even;    // the nearest value without these problems
};
PeriodInfo period_info(const Parameter& parameter, double value, const PeriodTerms& terms);
