#pragma once

#include "base/diagnostic.h"
#include "model/look/look.h"

#include <functional>
#include <string>
#include <variant>
#include <vector>

/// What sets a number of a shader: nothing, a fixed value, the program, or a parameter.
using EffectSetter = std::variant<std::monostate, Value, BuiltInUniform, const Parameter*>;

/// A uniform of a pass that is a number.
struct EffectNumber {
    std::string name;  // "block.member" for a member of a struct
    NumberType type;
    EffectSetter setter;
};

/// A struct of numbers, as translated shaders have them.
struct EffectStruct {
    std::string name;
    std::string type;
    std::vector<EffectNumber> members;
};

/// The uniforms of a pass, each once.
struct EffectUniforms {
    std::vector<EffectNumber> numbers;
    std::vector<EffectStruct> structs;
    std::vector<Input> samplers;      // those that are read
    std::vector<std::string> unread;  // samplers without an input, which read black
};

/// Finds the uniforms of a pass with glslang. Parameters in `fixed` are values. The parameters live
/// as long as the look.
Result<EffectUniforms> effect_uniforms(const Look& look, std::size_t pass, const Values& values,
                                       const std::vector<std::string>& fixed);

/// A value in GLSL: "0.5", "vec3(1.0, 0.0, 0.0)", "true".
std::string glsl_value(const NumberType& type, const Value& value);
/// The value 0 of a type.
std::string glsl_zero(const NumberType& type);
