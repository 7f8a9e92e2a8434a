#pragma once

#include "lab/choice.h"
#include "lab/document.h"
#include "model/source_spec.h"

/// "harbour"; "" for a file.
std::string name_of_pattern(const SourceSpec& source);

/// A pattern at one of the sizes that there are.
struct SourceSize {
    std::string name;  // "256 × 224"
    SourceSpec source;
};
/// None for a file.
std::vector<SourceSize> source_sizes(const SourceSpec& source);

/// The patterns, a file, and how it lies in the picture; nothing in a look that works on no
/// picture. `film_rate`: pictures a second of a source that has more than one.
std::vector<ChoiceList> source_choices(const Document& document, std::optional<double> film_rate);
