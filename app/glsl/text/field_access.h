#pragma once

#include "glsl/text/shader_names.h"

#include <string>
#include <string_view>

/// The type of the expression before ".field" on a line (from 1), such as "Ray" for
/// "rays[1].origin" and the field "origin"; "" if the line has no such access or its type is
/// unknown. `names` are those of that line.
std::string type_before_field(std::string_view text, int line, std::string_view field,
                              const ShaderNames& names);
