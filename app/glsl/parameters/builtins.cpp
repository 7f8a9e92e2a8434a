#include "glsl/parameters/builtins.h"

#include <algorithm>

const std::vector<BuiltInDeclaration>& builtin_uniforms() {
    static const std::vector<BuiltInDeclaration> all{
        {"u_time", {Scalar::floating, 1, 1}},               // seconds
        {"u_time_delta", {Scalar::floating, 1, 1}},         // seconds
        {"u_frame", {Scalar::integer, 1, 1}},               // from 1
        {"u_resolution", {Scalar::floating, 2, 1}},         // pixels of the pass's target
        {"u_output_resolution", {Scalar::floating, 2, 1}},  // pixels
        {"u_source_resolution", {Scalar::floating, 2, 1}},  // pixels
        {"u_source_lines", {Scalar::floating, 3, 1}},       // start, pitch, count
        {"u_source_columns", {Scalar::floating, 3, 1}},     // the same from the left
        {"u_mouse", {Scalar::floating, 2, 1}},              // pixels from bottom left
        {"u_samples", {Scalar::integer, 1, 1}},             // accumulated so far
        {"u_view", {Scalar::floating, 4, 4}},               // orbit: rotation of the object
        {"u_camera", {Scalar::floating, 4, 4}},             // orbit: rotation of the camera
        {"u_drawn_onto", {Scalar::boolean, 1, 1}},          // see "onto" in look.json
        {"u_subframe", {Scalar::integer, 1, 1}},            // from 0
        {"u_subframes", {Scalar::integer, 1, 1}},           // per source frame
        {"u_peak", {Scalar::floating, 1, 1}},               // largest light of the display
    };
    return all;
}

const BuiltInDeclaration* find_builtin_uniform(std::string_view name) {
    const auto& all = builtin_uniforms();
    const auto found = std::ranges::find(all, name, &BuiltInDeclaration::name);
    return found == all.end() ? nullptr : &*found;
}
