#pragma once

#include "formats/glsl/modern_glsl.h"
#include "model/look/look.h"

#include <string>
#include <string_view>
#include <vector>

/// One drawing of a text.
struct BarePass {
    std::string name;    // "u_buffer0", which is how the text reads it; of the last one "picture"
    std::string define;  // "BUFFER_0", which is how the text knows; "": nothing
};

/// The drawings that a text with such words asks for, in the order of glslViewer: its buffers, its
/// double buffers, the picture.
std::vector<BarePass> bare_passes(const GlslWords& words);

/// The uniforms by which other programs tell a fragment shader time, sizes and the mouse; the first
/// of equal names counts.
const std::vector<BuiltInUniform>& bare_built_ins();

/// Whether a sampler of that name is the picture that the shader works on.
bool is_bare_source(std::string_view sampler);

/// Whether glslViewer draws what a sampler of that name reads, if no pass of the text does.
bool is_drawn_by_viewer(std::string_view sampler);

/// The picture that stands for an unset sampler of that name, as Image::made.
const char* bare_stand_in(std::string_view sampler);
