#pragma once

#include "gpu/objects/name.h"
#include "model/look/parameter.h"

#include <optional>
#include <span>
#include <string>

namespace gpu {

/// An active uniform of a linked program.
struct Uniform {
    enum class Sampled { none, floating, integer, unsigned_integer, cube, volume, other };

    std::string name;  // without "[0]" for an array
    GLint location = -1;
    int count = 1;                     // array elements
    std::optional<NumberType> number;  // nullopt: a sampler, or not a parameter type
    Sampled sampled = Sampled::none;   // 2D, except cube, volume and other
};

/// From the results of glGetActiveUniform.
Uniform make_uniform(std::string name, GLint location, GLint count, GLenum type);

/// Writes components in GLSL's order (matrices by column) to a uniform of a program, which need not
/// be in use. Values out of an integer's range are clamped. Incomplete or missing elements are not
/// written. Does nothing for samplers.
void write_uniform(GLuint program, const Uniform& uniform, std::span<const double> numbers);

}  // namespace gpu
