#pragma once

#include "glsl/compile/tree.h"

#include <vector>

/// The uniforms of both stages, each name once. Conflicting declarations are reported at the
/// fragment shader's declaration.
std::vector<Uniform> merged_uniforms(const StageInterface& vertex, const StageInterface& fragment,
                                     Diagnostics& problems);

/// Reports fragment inputs that the vertex shader does not write, or writes with another type.
/// `fragment_stage` provides the lines.
void check_varyings(const StageInterface& vertex, const StageInterface& fragment,
                    const Stage& fragment_stage, Diagnostics& problems);

/// The line of the first use of a name in a text; 1 if it is not used.
int first_line_of(std::string_view name, std::string_view text);

/// " (at beam.vert:3)", or "" for a location in built-in text.
std::string location_suffix(const Location& at);
