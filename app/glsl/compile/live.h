#pragma once

#include <string>
#include <vector>

namespace glslang {
class TShader;
}

/// The uniforms that reachable code reads: in called functions and in branches whose condition is
/// not a constant false. The shader was parsed without errors, and it and its memory pool must
/// still exist.
std::vector<std::string> live_uniforms(glslang::TShader& shader);
