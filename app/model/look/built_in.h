#pragma once

#include "model/look/input.h"

#include <optional>
#include <string>
#include <vector>

/// What the program itself says in a uniform of a pass. Sizes are in pixels.
enum class BuiltIn {
    time,          // of the frame's end, s
    time_delta,    // s
    frame,         // from 1, after the pass's modulo
    samples,       // accumulated so far
    target_size,   // of the pass
    output_size,   // of the whole picture
    source_size,   // of what the look reads as the source
    source_lines,  // start, pitch, count: see RasterAxis
    source_columns,
    mouse,          // from the bottom left of the picture
    view,           // orbit: the object's turn, a matrix
    camera,         // orbit: the camera's
    drawn_onto,     // whether passes draw onto its target, or onto one that it reads
    frame_before,   // from 0, after the pass's modulo
    microseconds,   // since the frame before
    source_aspect,  // width to height, as it is to be seen
    time_before,    // of the frame's start, s: 0 in the first one
    delta_before,   // since the frame before, s: 0 in the first one
    date,           // year, month from 1, day, seconds since midnight
    date_from_0,    // the same, its month from 0
    quad_to_clip,   // the matrix that draws the quad over the whole target, a picture's top on top
    frame_rate,     // frames a second, by time_delta
    press,          // of the mouse: see Press::numbers
    // width, height, and 1 for the shape of a pixel:
    target_resolution,
    input_resolution,  // of what `of` reads
    // width, height, 1/width, 1/height:
    target_extent,
    output_extent,
    input_extent,  // of what `of` reads
};

/// A uniform that no person turns, and what it says.
struct BuiltInUniform {
    std::string name;
    BuiltIn says = BuiltIn::time;
    std::optional<Input> of = std::nullopt;  // of input_extent and input_resolution

    bool operator==(const BuiltInUniform&) const = default;
};

/// Those that a look of Afterglow's own has: `u_time` and so on.
const std::vector<BuiltInUniform>& own_built_ins();

/// Whether it says something else in the next frame.
bool tells_time(BuiltIn says);
