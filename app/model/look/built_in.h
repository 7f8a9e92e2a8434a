#pragma once

#include "model/look/input.h"

#include <optional>
#include <string>
#include <vector>

/// A value that the program writes to a uniform of a pass. Sizes are in pixels.
enum class BuiltIn {
    time,          // at the frame's end, s
    time_delta,    // s
    frame,         // from 1, after the pass's modulo
    samples,       // accumulated so far
    target_size,   // of the pass
    output_size,   // of the whole picture
    source_size,   // of the picture that the look reads as the source
    source_lines,  // start, pitch, count: see RasterAxis
    source_columns,
    mouse,            // from the bottom left of the picture
    view,             // orbit: the object's rotation, a matrix
    camera,           // orbit: the camera's matrix
    drawn_onto,       // whether passes draw onto its target, or onto one that it reads
    frame_index,      // from 0, after the pass's modulo
    microseconds,     // since the previous frame
    source_aspect,    // width / height as displayed
    time_before,      // at the frame's start, s: 0 in the first frame
    delta_before,     // since the previous frame, s: 0 in the first frame
    date,             // year, month from 1, day, seconds since midnight
    date_from_0,      // as date, but month from 0
    quad_to_clip,     // matrix that maps the quad to the whole target, a picture's top at the top
    frame_rate,       // frames per second, from time_delta
    press,            // of the mouse: see Press::numbers
    subframe,         // from 0
    subframe_number,  // from 1
    subframes,        // per source frame
    peak,             // the largest light that the display can show; 1 without HDR
    hdr_mode,         // of libretro: 0 without HDR, 2 for light in units of 80 cd/m2
    paper_white,      // of HDR, cd/m2
    source_frame_index,  // of the source frame, from 0, after the pass's modulo
    // width, height, and 1 for the pixel aspect ratio:
    target_resolution,
    input_resolution,  // of the input `of`
    // width, height, 1/width, 1/height:
    target_extent,
    output_extent,
    input_extent,  // of the input `of`
};

/// A uniform that the program sets, not the user, and its value.
struct BuiltInUniform {
    std::string name;
    BuiltIn kind = BuiltIn::time;
    std::optional<Input> of = std::nullopt;  // for input_extent and input_resolution

    bool operator==(const BuiltInUniform&) const = default;
};

/// The uniforms of Afterglow's own looks: `u_time` and so on.
const std::vector<BuiltInUniform>& own_built_ins();

/// Whether the value changes from frame to frame.
bool tells_time(BuiltIn kind);
