#pragma once

#include "formats/slang/files.h"
#include "formats/slang/parameters.h"
#include "model/look/look.h"

/// A .slang file as its reader understands it: two stages for the compiler, and what the pragmas
/// say.
struct SlangShader {
    // GLSL for Vulkan, with the includes in place and without what was for the reader: a pragma's
    // line is empty. The other stage's lines are left out. `file` is the .slang file.
    Stage vertex;
    Stage fragment;
    std::string alias;   // #pragma name; "": none
    std::string format;  // #pragma format, the word as it stands there; "": none
    Location alias_declared;
    Location format_declared;
    SlangParameters parameters;  // in order, each id once
    Diagnostics warnings;
};

/// Reads a shader with its includes. Text before the first `#pragma stage` belongs to both stages,
/// and a stage may be opened again. Behind `#version` stand the definitions by which shaders ask
/// whether the program gives the aspect, frame time, rotation and sensor uniforms. Errors (several
/// at once, each at its line): what expand_slang says, a first line that is no `#version`, an
/// unknown stage, a parameter's line that cannot be read, more than 16,384 parameters.
Result<SlangShader> read_slang_shader(const std::filesystem::path& file, SlangFiles& files);
