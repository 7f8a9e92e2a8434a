#pragma once

#include "lab/document/document.h"

#include <string>
#include <vector>

/// A value that differs from the look's default, as texts.
struct GalleryValue {
    std::string heading;  // of the parameter: "Tone mapping"
    std::string label;
    std::string text;        // with unit
    std::string color;       // of a swatch: "#rrggbb"; "": none
    std::string modulation;  // "LFO, sine, rate 0.5 Hz, depth 0.25"; "": none
};

/// A further property: "Signal" and "lissajous:x=3,y=2".
struct GalleryFact {
    std::string label;
    std::string text;
};

/// What a gallery shows of a look or preset.
struct GalleryCard {
    std::string name;
    std::string about;
    std::string author;
    std::vector<GalleryFact> facts;
    std::vector<GalleryValue> values;
    std::string share_line;
    std::string thumbnail;  // path in the gallery
    std::string page;       // path in the gallery; "": none
    std::string why_no_page;
};

/// The texts of a card. Files are shown without their folders.
GalleryCard gallery_card(const Document& document);
