#pragma once

#include "formats/effect/effect_controls.h"
#include "formats/portable/exact_picture.h"
#include "model/look/look.h"

#include <string>
#include <string_view>
#include <vector>

/// A picture file of a preset.
struct SlangPictureFile {
    std::string name;  // in shaders
    std::string path;
    Sampler sampler;
    PictureFile file;
};

/// The name of a black picture, which samplers without an input read.
inline constexpr const char* slang_black = "black_picture";

/// The pictures of a look as files in `folder`, the first row at the top, display-encoded.
Result<std::vector<SlangPictureFile>> slang_pictures(const Look& look, const std::string& folder,
                                                     bool has_black);

/// The preset: passes with their sizes and samplers, then the pictures. `shaders`: the path of each
/// pass.
std::string slang_preset_text(const Look& look, const std::vector<std::string>& shaders,
                              const std::vector<SlangPictureFile>& pictures);

/// The line for a component of a parameter.
std::string slang_parameter_line(const EffectControl& control, std::size_t component,
                                 const std::string& name);
