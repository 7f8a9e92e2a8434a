#pragma once

#include "formats/effect/effect_controls.h"
#include "formats/effect/effect_pictures.h"
#include "model/look/look.h"

#include <string>
#include <string_view>
#include <vector>

/// The name of a black picture, which samplers without an input read.
inline constexpr const char* slang_black = "black_picture";

/// The preset: passes with their sizes and samplers, then the pictures. `shaders`: the path of each
/// pass.
std::string slang_preset_text(const Look& look, const std::vector<std::string>& shaders,
                              const std::vector<EffectPicture>& pictures);

/// The line for a component of a parameter.
std::string slang_parameter_line(const EffectControl& control, std::size_t component,
                                 const std::string& name);
