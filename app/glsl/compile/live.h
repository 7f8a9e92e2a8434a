#pragma once

#include <string>
#include <vector>

namespace glslang {
class TShader;
}

/// The uniforms that a shader reads where it can be reached: in functions that are called, in
/// branches whose condition is not known to be false. It was parsed without errors; while it and
/// its memory live.
std::vector<std::string> live_uniforms(glslang::TShader& shader);
