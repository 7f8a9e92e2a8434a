#pragma once

#include "formats/slang/files.h"
#include "formats/slang/parameters.h"
#include "model/look/look.h"

/// A parsed .slang file: two stages for the compiler, and the values of its pragmas.
struct SlangShader {
    // GLSL for Vulkan with expanded includes. Lines of pragmas are empty. Lines of the other stage
    // are omitted. `file` is the .slang file.
    Stage vertex;
    Stage fragment;
    std::string alias;   // #pragma name; "": none
    std::string format;  // #pragma format, as written; "": none
    Location alias_declared;
    Location format_declared;
    SlangParameters parameters;  // in order, each id once
    Diagnostics warnings;
};

/// Reads a shader with its includes. Text before the first `#pragma stage` belongs to both stages.
/// A stage may be reopened. After `#version`, the host definitions for aspect, frame time, rotation
/// and sensor uniforms are added. Errors, several at once, at their lines: those of expand_slang(),
/// a first line other than `#version`, an unknown stage, an invalid parameter, more than 16,384
/// parameters.
Result<SlangShader> read_slang_shader(const std::filesystem::path& file, SlangFiles& files);
