#pragma once

#include "lab/document/document.h"
#include "lab/messages/choice.h"
#include "model/picture/source_spec.h"

class Drive;

/// The source with a pattern as its picture: fit and shape stay, and it is not pre-scaled.
SourceSpec with_pattern(SourceSpec source, const std::string& name);

/// The source with one of its settings chosen.
struct NamedSource {
    std::string name;
    SourceSpec source;
};
/// A pattern at the sizes that there are: "256 × 224". None for a file.
std::vector<NamedSource> source_sizes(const SourceSpec& source);
/// Square pixels, 4:3, 16:9, Custom, and the source's own ratio if it is none of these. `extent`:
/// its size in pixels.
std::vector<NamedSource> source_shapes(const SourceSpec& source, Extent extent);
/// Auto, 1× to 8×; none for a pattern. `found`: the enlargement that was found in the picture.
std::vector<NamedSource> source_prescales(const SourceSpec& source, std::optional<int> found);

/// What is known of a source that is open.
struct OpenSource {
    Extent extent = {};                    // empty: not yet
    std::optional<int> prescale = {};      // as set or as found
    std::optional<double> film_rate = {};  // pictures a second, where there is more than one
};
OpenSource open_source(const Drive& drive);

/// The patterns, a file, and how it lies in the picture; nothing in a look that works on no
/// picture.
std::vector<ChoiceList> source_choices(const Document& document, const OpenSource& open);
