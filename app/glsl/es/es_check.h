#pragma once

#include <string>

/// Compiles a shader in GLSL ES 3.00 as browsers require. Returns the first error; "" if it is
/// good.
std::string es_error(const std::string& text, bool is_fragment);
