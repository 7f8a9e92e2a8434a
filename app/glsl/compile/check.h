#pragma once

#include "model/look/look.h"
#include "model/look/shader_limits.h"

#include <optional>
#include <string>
#include <vector>

namespace glslang {
class TShader;
}

/// A uniform as the shaders of a pass declare it.
struct Uniform {
    enum class Kind { number, sampler, other };

    std::string name;  // a block's own name
    Kind kind = Kind::other;
    std::string type_name;           // as GLSL writes it: "vec3", "sampler2D", "float[4]"
    NumberType type;                 // of a number
    std::string why_no_control;      // of all else but samplers
    std::optional<Value> initial;    // of a number, when it is initialised
    std::vector<Location> declared;  // one a stage that declares it

    bool operator==(const Uniform&) const = default;
};

/// What the stages of a pass declare.
struct Reflection {
    std::vector<Uniform> uniforms;  // each name once, in order of declaration, vertex stage first
    std::vector<std::string> live;  // those of them that some code reads that can be reached
    Diagnostics warnings;           // glslang's

    bool operator==(const Reflection&) const = default;
};

/// Checks both stages and their fitting together with glslang, as for a driver of OpenGL 4.1 core.
/// Errors are glslang's messages at the author's file and line; also a missing #version, a default
/// that no 32-bit float holds, more than 256 varyings, and shaders that exceed a limit.
Result<Reflection> check_program(const Stage& vertex, const Stage& fragment,
                                 const ShaderLimits& limits = {});

/// Refuses a text that glslang would take too much time or memory for, as find_out_of_bounds and
/// find_large_declaration say.
void check_bounds(const Stage& stage, const ShaderLimits& limits, Diagnostics& problems);

/// Refuses a shader that was parsed without errors and that exceeds a limit. The error lies at the
/// author's line where one is to blame.
void check_cost(glslang::TShader& shader, const Stage& stage, const ShaderLimits& limits,
                Diagnostics& problems);

/// Builds glslang's built-in tables, which the first check would otherwise wait for (20 ms).
void warm_up();

/// "a vec2", "an ivec2": a type in a sentence.
std::string with_article(const std::string& type_name);

/// The author's place of a line of a stage.
Location place_in(const Stage& stage, int line);
