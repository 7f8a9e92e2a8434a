#pragma once

#include "glsl/annotations/hint.h"
#include "glsl/cache/check_cache.h"

#include <string>
#include <vector>

/// A uniform of one pass that a parameter drives.
struct FreeUniform {
    std::string parameter;  // the uniform's name, or what `rename` says
    Uniform uniform;
    Hints hints;
    Binding binding;
};

/// What the shaders of one pass leave for parameters.
struct PassUniforms {
    std::vector<FreeUniform> free;
    std::vector<std::string> built_in;  // that it declares
    Diagnostics errors;
    Diagnostics warnings;
};

/// Checks a pass and sorts its uniforms: built-in ones, inputs and those that are `set` are not
/// free.
PassUniforms find_pass_uniforms(const Pass& pass, int index, CheckCache* cache);
