#pragma once

#include "lab/document/document.h"
#include "lab/messages/menu_entry.h"
#include "model/picture/source_spec.h"

class MediaInput;

/// The source with a pattern as its picture; fit and shape stay, prescale becomes 1.
SourceSpec with_pattern(SourceSpec source, const std::string& name);

/// The source with one changed setting.
struct NamedSource {
    std::string name;
    SourceSpec source;
};
/// The sizes of a pattern: "256 × 224". Empty for a file.
std::vector<NamedSource> source_sizes(const SourceSpec& source);
/// Square pixels, 4:3, 16:9, Custom, and the source's own ratio if it differs. `extent`: the size
/// of the source in pixels.
std::vector<NamedSource> source_shapes(const SourceSpec& source, Extent extent);
/// Auto, 1× to 8×; empty for a pattern. `found`: the detected prescale.
std::vector<NamedSource> source_prescales(const SourceSpec& source, std::optional<int> found);

/// The properties of the open source.
struct OpenSource {
    Extent extent = {};                    // empty: not loaded yet
    std::optional<int> prescale = {};      // as set or detected
    std::optional<double> film_rate = {};  // pictures/s of a film
};
OpenSource open_source(const MediaInput& media);

/// Pattern, file and fit; empty if the look does not use a picture.
std::vector<MenuSection> source_sections(const Document& document, const OpenSource& open);
