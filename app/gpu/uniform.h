#pragma once

#include "gpu/objects/name.h"
#include "model/look/parameter.h"

#include <optional>
#include <span>
#include <string>

namespace gpu {

/// A uniform that a linked program really uses.
struct Uniform {
    enum class Sampled { none, floating, integer, natural, cube, volume, other };

    std::string name;  // an array's without "[0]"
    GLint location = -1;
    int count = 1;                     // elements of an array
    std::optional<NumberType> number;  // none: a sampler, or a type that no parameter has
    Sampled sampled = Sampled::none;   // of a 2D texture but for cube, volume, other
};

/// From what glGetActiveUniform says.
Uniform make_uniform(std::string name, GLint location, GLint count, GLenum type);

/// Writes components in GLSL's order (matrices by column) to a uniform of a program, which need not
/// be in use. Numbers that an integer cannot hold go to its nearest; components that are missing
/// are left as they are by whole elements. Nothing for samplers.
void write_uniform(GLuint program, const Uniform& uniform, std::span<const double> numbers);

}  // namespace gpu
