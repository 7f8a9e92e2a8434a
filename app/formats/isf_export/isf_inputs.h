#pragma once

#include "formats/effect/effect_controls.h"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

/// A control of an ISF file.
struct IsfControl {
    EffectControl control;
    std::vector<std::string> names;  // of its inputs in the header
    bool is_direct = false;  // the host declares a uniform of that name and the shader's type
};

/// Gives each control the names of its inputs.
std::vector<IsfControl> isf_controls(std::vector<EffectControl> controls, EffectNames& names);

/// The entries of INPUTS for a control.
nlohmann::ordered_json isf_inputs(const IsfControl& control);

/// The value for the shader, of the control's inputs, in GLSL. Colours are linear light, by
/// decoding_function.
std::string isf_value(const IsfControl& control, const NumberType& type);
