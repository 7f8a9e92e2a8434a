#pragma once

#include "base/diagnostic.h"

#include <filesystem>
#include <string>

/// Translates a fragment shader in GLSL 4.10 to HLSL for Shader Model 5.0. Uniforms that are no
/// samplers stay plain uniforms. Arrays of arrays become one array. The function `frag_main` reads
/// the inputs and writes the outputs, which are static variables with the names of the GLSL text.
/// The error is the compiler's message, at `file`.
Result<std::string> fragment_hlsl(const std::string& text, const std::filesystem::path& file);
