#pragma once

#include <string>
#include <string_view>
#include <vector>

/// The name of a type that glslang describes in a message: "vec3" for " temp 3-component vector of
/// float", "float[2]" for " const 2-element array of float". Qualifiers and precision are left out.
/// A struct or block is "struct" or "block"; see described_fields().
std::string glsl_type_name(std::string_view description);

/// The names of the fields of a struct or block that glslang describes; empty for other types.
std::vector<std::string> described_fields(std::string_view description);
