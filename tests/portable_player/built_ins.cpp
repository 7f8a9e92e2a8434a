// The values of uniforms that the player sets: docs/portable.md, "Built-in values".
#include "portable_player/built_ins.h"

#include <cmath>
#include <functional>
#include <map>

namespace {
using Numbers = std::vector<double>;

constexpr double frame_seconds = 1.0 / 60.0;

Numbers pair(const Size& size) {
    return {1.0 * size[0], 1.0 * size[1]};
}

Numbers resolution(const Size& size) {
    return {1.0 * size[0], 1.0 * size[1], 1.0};
}

Numbers extent(const Size& size) {
    return {1.0 * size[0], 1.0 * size[1], 1.0 / size[0], 1.0 / size[1]};
}

Numbers raster(const Raster& lines) {
    return {lines[0], lines[1], lines[2]};
}

// After `frame_modulo`.
double counted(int number, const PassState& state) {
    return state.frame_modulo > 0 ? number % state.frame_modulo : number;
}

// The first of January 2000, at midnight before the first frame.
Numbers date(const PassState& state, double first_month) {
    constexpr double day = 86400.0;
    const double seconds = state.number * frame_seconds;
    return {2000.0, first_month, 1.0 + std::floor(seconds / day), std::fmod(seconds, day)};
}

// The quad's y points down from the top of the picture.
Numbers quad_to_clip(const PassState& state) {
    const double down = state.is_top_first ? 1.0 : -1.0;
    return {2, 0, 0, 0, 0, 2 * down, 0, 0, 0, 0, 1, 0, -1, -down, 0, 1};
}

using NumbersOf = std::function<Numbers(const PassState&)>;

const std::map<std::string, NumbersOf> values{
    {"time", [](const PassState& s) -> Numbers { return {s.number * frame_seconds}; }},
    {"time_before", [](const PassState& s) -> Numbers { return {(s.number - 1) * frame_seconds}; }},
    {"time_delta", [](const PassState&) -> Numbers { return {frame_seconds}; }},
    {"delta_before",
     [](const PassState& s) -> Numbers { return {s.number > 1 ? frame_seconds : 0.0}; }},
    {"microseconds", [](const PassState&) -> Numbers { return {std::round(1e6 * frame_seconds)}; }},
    {"frame_rate", [](const PassState&) -> Numbers { return {60.0}; }},
    {"frame", [](const PassState& s) -> Numbers { return {counted(s.number, s)}; }},
    {"frame_index", [](const PassState& s) -> Numbers { return {counted(s.number - 1, s)}; }},
    {"source_frame_index",
     [](const PassState& s) -> Numbers { return {counted(s.number - 1, s)}; }},
    {"subframe", [](const PassState&) -> Numbers { return {0.0}; }},
    {"subframe_number", [](const PassState&) -> Numbers { return {1.0}; }},
    {"subframes", [](const PassState&) -> Numbers { return {1.0}; }},
    {"peak", [](const PassState&) -> Numbers { return {1.0}; }},
    {"hdr_mode", [](const PassState&) -> Numbers { return {0.0}; }},
    {"paper_white", [](const PassState&) -> Numbers { return {200.0}; }},
    {"samples", [](const PassState& s) -> Numbers { return {1.0 * s.samples}; }},
    {"target_size", [](const PassState& s) { return pair(s.target); }},
    {"output_size", [](const PassState& s) { return pair(s.view); }},
    {"source_size", [](const PassState& s) { return pair(s.source); }},
    {"source_lines", [](const PassState& s) { return raster(s.source_lines); }},
    {"source_columns", [](const PassState& s) { return raster(s.source_columns); }},
    {"source_aspect",
     [](const PassState& s) -> Numbers {
         return {s.source_pixel_aspect * s.source[0] / s.source[1]};
     }},
    {"target_resolution", [](const PassState& s) { return resolution(s.target); }},
    {"input_resolution", [](const PassState& s) { return resolution(s.of); }},
    {"target_extent", [](const PassState& s) { return extent(s.target); }},
    {"output_extent", [](const PassState& s) { return extent(s.view); }},
    {"input_extent", [](const PassState& s) { return extent(s.of); }},
    {"mouse",
     [](const PassState&) -> Numbers {
         return {0.0, 0.0};
     }},
    {"press",
     [](const PassState&) -> Numbers {
         return {0.0, 0.0, 0.0, 0.0};
     }},
    {"drawn_onto", [](const PassState& s) -> Numbers { return {s.is_drawn_onto ? 1.0 : 0.0}; }},
    {"date", [](const PassState& s) { return date(s, 1.0); }},
    {"date_from_0", [](const PassState& s) { return date(s, 0.0); }},
    {"quad_to_clip", quad_to_clip}};
}  // namespace

std::vector<double> numbers_of(const std::string& value, const PassState& state) {
    const auto found = values.find(value);
    return found == values.end() ? Numbers() : found->second(state);
}

Raster own_raster(int count) {
    return {0.0, 1.0 / count, static_cast<double>(count)};
}
