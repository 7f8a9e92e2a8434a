#pragma once

#include "base/diagnostic.h"
#include "model/look/extent.h"
#include "model/picture/live_spec.h"

#include <optional>
#include <string>
#include <string_view>

/// How a source picture fits the picture that a look draws.
enum class Fit {
    stretch,  // fills the picture
    whole,    // all of it, with black borders
    crop,     // fills the picture; the excess is cropped
    integer,  // scaled by an integer, with a black border
};

/// The displayed aspect ratio of a picture: 4:3.
struct ShapeRatio {
    double width = 4.0;
    double height = 3.0;

    bool operator==(const ShapeRatio&) const = default;
};

/// A source picture by name, with its display settings: "frame_%04d.png,fit=whole,rate=25".
struct SourceSpec {
    std::string picture;  // "pattern:NAME" or a live source with its own settings, or a file
    Fit fit = Fit::stretch;
    double aspect = 1.0;  // width / height of a pixel; ignored when stretched
    double rate = 0.0;    // pictures per second of a sequence or video; 0: its own, or 60
    bool loops = true;    // restarts after the last picture; otherwise that one stays
    std::optional<ShapeRatio> shape = std::nullopt;  // of the whole picture; nullopt: use `aspect`
    int prescaled = 1;  // pixels per side that show one original pixel; 0: detected

    bool operator==(const SourceSpec&) const = default;
    bool is_pattern() const { return picture.starts_with("pattern:"); }
    bool is_live() const { return ::is_live(picture); }
    bool is_file() const { return !picture.empty() && !is_pattern() && !is_live(); }
};

constexpr int largest_prescale = 8;

/// Parses a source with the settings fit, aspect, shape, prescaled, rate and loop at its end.
/// Everything before them, commas included, is the file name, pattern or
/// live source. `usual`: default settings.
/// Errors have no file.
Result<SourceSpec> parse_source(std::string_view text, const SourceSpec& usual = {});

/// Width / height of a pixel of the source.
double pixel_aspect(const SourceSpec& source, Extent extent);

/// Formats a source so that parse_source reads the same source; defaults are omitted.
std::string to_string(const SourceSpec& source);

/// "stretch", "whole", "crop", "integer".
std::string_view fit_name(Fit fit);
std::optional<Fit> find_fit(std::string_view name);
