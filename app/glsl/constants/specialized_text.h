#pragma once

#include "model/look/parameter.h"

#include <map>
#include <string>

/// The constant value of a uniform.
struct SpecializedUniform {
    NumberType type;
    Value value;

    bool operator==(const SpecializedUniform&) const = default;
};

/// Specialises the text: replaces these uniforms by variables with a constant initialiser.
/// Compilers treat them as constants and remove disabled code. Only uniforms with their own
/// statement (`uniform float gain = 1.0;`) and values that GLSL can express are replaced. Line
/// numbers are unchanged.
std::string specialized_text(const std::string& text,
                             const std::map<std::string, SpecializedUniform>& uniforms);
