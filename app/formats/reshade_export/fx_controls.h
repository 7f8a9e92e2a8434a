#pragma once

#include "formats/effect/effect_controls.h"

#include <string>
#include <vector>

/// A parameter as a uniform of ReShade FX.
struct FxControl {
    enum class Kind { checkbox, combo, slider, color };

    EffectControl control;  // its id is the name of the uniform
    Kind kind = Kind::slider;
    NumberType type;  // of the uniform; that of a combo is the index of an item
};

/// Whether a uniform can hold the parameter: a number or a vector of numbers.
bool fits_fx(const Parameter& parameter);

/// `control` with the name of its uniform.
FxControl fx_control(EffectControl control);

/// The type in HLSL: "float3".
std::string hlsl_name(const NumberType& type);

/// The declaration with its annotations and the present value. `look`: that of the parameter.
std::string fx_declaration(const FxControl& control, const Look& look);

/// The parameter's value in GLSL, converted to a type.
std::string fx_glsl_value(const FxControl& control, const NumberType& type);

/// The present value in a ReShade preset: "0.5,1,0".
std::string fx_preset_value(const FxControl& control);
/// The present value in vkBasalt.conf. "": a vector, which it can't hold.
std::string fx_setting_value(const FxControl& control);
