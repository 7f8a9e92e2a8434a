#pragma once

#include "model/look/parameter.h"

#include <map>
#include <string>

/// What a uniform is to hold for good.
struct SettledUniform {
    NumberType type;
    Value value;

    bool operator==(const SettledUniform&) const = default;
};

/// The text with these uniforms as plain variables of their value, which compilers take as the
/// constants that they are: what such values switch off costs nothing any more. Only those that
/// have a statement of their own (`uniform float gain = 1.0;`); others, and values that GLSL cannot
/// write, stay uniforms. Lines keep their numbers.
std::string settled_text(const std::string& text,
                         const std::map<std::string, SettledUniform>& uniforms);
