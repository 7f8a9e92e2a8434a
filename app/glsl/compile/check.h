#pragma once

#include "model/look/look.h"
#include "model/look/shader_limits.h"

#include <optional>
#include <string>
#include <vector>

namespace glslang {
class TShader;
}

/// A uniform declared by the shaders of a pass.
struct Uniform {
    enum class Kind { number, sampler, other };

    std::string name;  // for a block, the block's name
    Kind kind = Kind::other;
    std::string type_name;           // as in GLSL: "vec3", "sampler2D", "float[4]"
    NumberType type;                 // for numbers
    std::string why_no_control;      // for all kinds except numbers and samplers
    std::optional<Value> initial;    // for numbers with an initialiser
    std::vector<Location> declared;  // one per stage that declares it

    bool operator==(const Uniform&) const = default;
};

/// The declarations of a pass's stages.
struct Reflection {
    std::vector<Uniform> uniforms;  // each name once, in order of declaration, vertex stage first
    std::vector<std::string> live;  // uniforms read by reachable code
    Diagnostics warnings;           // from glslang

    bool operator==(const Reflection&) const = default;
};

/// Checks both stages and their interface with glslang, for an OpenGL 4.1 core driver. Errors are
/// glslang's messages at the author's file and line. Also errors: a missing #version, a default
/// that does not fit a 32-bit float, more than 256 varyings, shaders that exceed a limit.
Result<Reflection> check_program(const Stage& vertex, const Stage& fragment,
                                 const ShaderLimits& limits = {});

/// Reports a text that would take glslang too much time or memory. See find_limit_violation() and
/// find_large_declaration().
void check_bounds(const Stage& stage, const ShaderLimits& limits, Diagnostics& problems);

/// Reports a shader, parsed without errors, that exceeds a limit. The error is at the author's line
/// if a line causes it. Loops without a bound are warnings.
void check_cost(glslang::TShader& shader, const Stage& stage, const ShaderLimits& limits,
                Diagnostics& problems);

/// Builds glslang's built-in tables ahead of the first check, which would otherwise wait 20 ms.
void warm_up();

/// A type name with its article: "a vec2", "an ivec2".
std::string with_indefinite_article(const std::string& type_name);

/// The author's location of a line of a stage.
Location location_in(const Stage& stage, int line);
