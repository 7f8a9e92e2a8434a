#pragma once

#include <span>
#include <vector>

/// The widths in the strip that a pass or a pyramid requests.
struct AskedWidth {
    float minimum = 0.0f;  // if room is short
    float wanted = 0.0f;   // a pass: all text fits; a pyramid: whole pictures fit
    float best = 0.0f;     // the largest useful width, at least `wanted`
    bool is_pass = true;   // false: the levels of a pyramid
};

/// The resulting widths.
struct StripWidths {
    std::vector<float> widths;
    bool is_narrow = false;  // the full text of single passes does not fit
};

/// If all passes can have `wanted`, they are served first, then up to `best`; pyramids get the
/// remainder. Otherwise all widths grow from `minimum` towards `wanted` by the same share. If even
/// `minimum` does not fit, the row is longer than `room`. `room` excludes the gaps. Widths are
/// whole numbers.
StripWidths strip_widths(std::span<const AskedWidth> asked, float room);
