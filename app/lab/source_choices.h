#pragma once

#include "lab/choice.h"
#include "lab/document.h"

/// The patterns, a file, and how it lies in the picture; nothing in a look that works on no
/// picture. `film_rate`: pictures a second of a source that has more than one.
std::vector<ChoiceList> source_choices(const Document& document, std::optional<double> film_rate);
