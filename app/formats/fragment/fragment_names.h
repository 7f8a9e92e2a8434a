#pragma once

#include "formats/glsl/modern_glsl.h"
#include "model/look/look.h"

#include <string>
#include <string_view>
#include <vector>

/// One pass of a text.
struct FragmentPass {
    std::string name;    // "u_buffer0", its sampler in the text; "picture" for the last pass
    std::string define;  // "BUFFER_0", defined for this pass; "": no define
};

/// The passes for a text with these words, in the order of glslViewer: buffers, double buffers, the
/// picture.
std::vector<FragmentPass> fragment_passes(const GlslWords& words);

/// Uniforms of other programs for time, sizes and the mouse. The first of equal names counts.
const std::vector<BuiltInUniform>& fragment_built_ins();

/// Whether a sampler with that name is the input picture of the shader.
bool is_fragment_source(std::string_view sampler);

/// Whether glslViewer renders the content of a sampler with that name, if no pass of the text does.
bool is_drawn_by_viewer(std::string_view sampler);

/// The default picture for an unset sampler with that name, as Image::made.
const char* default_picture(std::string_view sampler);
