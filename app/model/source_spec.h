#pragma once

#include "base/diagnostic.h"

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

/// A source picture asked for by name, and how it is shown: "frame_%04d.png,fit=whole,rate=25".
struct SourceSpec {
    std::string picture;  // "pattern:NAME", with its own settings, or a file
    Fit fit = Fit::stretch;
    double aspect = 1.0;  // width of a pixel against its height; no matter when stretched
    double rate = 0.0;    // pictures a second of a sequence or video; 0: its own, or 60
    bool loops = true;    // from the last picture on to the first; else the last one stays

    bool operator==(const SourceSpec&) const = default;
    bool is_pattern() const { return picture.starts_with("pattern:"); }
};

/// Reads a source with its settings fit, aspect, rate and loop, which stand at the end; commas and
/// all else before them belong to the file's name or the pattern. `usual`: its fit where it says
/// none. Errors carry no file.
Result<SourceSpec> parse_source(std::string_view text, Fit usual = Fit::stretch);

/// The text that parse_source reads as the same source; what is as usual is left out.
std::string to_string(const SourceSpec& source);

/// "stretch", "whole", "crop", "integer".
std::string_view fit_name(Fit fit);
std::optional<Fit> find_fit(std::string_view name);
