#pragma once

#include "base/diagnostic.h"
#include "model/look/extent.h"

#include <optional>
#include <string>
#include <string_view>

/// How a source picture lies in the picture that a look draws.
enum class Fit {
    stretch,  // over all of it
    whole,    // all of it to be seen, black beside it
    crop,     // no black; what sticks out is cut off
    integer,  // each of its pixels the same whole number of pixels, black around it
};

/// Width and height of a picture as it is seen, in any unit: 4:3.
struct ShapeRatio {
    double width = 4.0;
    double height = 3.0;

    bool operator==(const ShapeRatio&) const = default;
};

/// A source picture asked for by name, and how it is shown: "frame_%04d.png,fit=whole,rate=25".
struct SourceSpec {
    std::string picture;  // "pattern:NAME", with its own settings, or a file
    Fit fit = Fit::stretch;
    double aspect = 1.0;  // width of a pixel against its height; no matter when stretched
    double rate = 0.0;    // pictures a second of a sequence or video; 0: its own, or 60
    bool loops = true;    // from the last picture on to the first; else the last one stays
    std::optional<ShapeRatio> shape = std::nullopt;  // of the whole picture; none: by `aspect`
    int prescaled = 1;  // pixels along a side that show one pixel of the original; 0: as found

    bool operator==(const SourceSpec&) const = default;
    bool is_pattern() const { return picture.starts_with("pattern:"); }
};

constexpr int largest_prescale = 8;

/// Reads a source with its settings fit, aspect, shape, prescaled, rate and loop, which stand at
/// the end; commas and all else before them belong to the file's name or the pattern. `usual`: the
/// settings of a text that says none. Errors carry no file.
Result<SourceSpec> parse_source(std::string_view text, const SourceSpec& usual = {});

/// Width to height of a pixel of the source.
double pixel_aspect(const SourceSpec& source, Extent extent);

/// The text that parse_source reads as the same source; what is as usual is left out.
std::string to_string(const SourceSpec& source);

/// "stretch", "whole", "crop", "integer".
std::string_view fit_name(Fit fit);
std::optional<Fit> find_fit(std::string_view name);
