#pragma once

#include "glsl/compile/tree.h"

#include <vector>

/// The uniforms of both stages, each name once. Declarations of one name that disagree are reported
/// at the fragment shader's.
std::vector<Uniform> merged_uniforms(const StageInterface& vertex, const StageInterface& fragment,
                                     Diagnostics& problems);

/// Reports what the fragment shader reads and the vertex shader does not give, or gives as another
/// type. `fragment_stage` is where the words of the fragment shader are found.
void check_varyings(const StageInterface& vertex, const StageInterface& fragment,
                    const Stage& fragment_stage, Diagnostics& problems);

/// The line of the first use of a name in a text; 1 when there is none.
int first_line_of(std::string_view name, std::string_view text);

/// " (at beam.vert:3)", or nothing for a place in the program's own text.
std::string aside(const Location& at);
