#pragma once

#include "glsl/annotations/hint.h"
#include "glsl/cache/check_cache.h"

#include <string>
#include <vector>

/// A uniform of one pass that is driven by a parameter.
struct FreeUniform {
    std::string parameter;  // the uniform's name, or its new name in `rename`
    Uniform uniform;
    Hints hints;
    Binding binding;
};

/// The uniforms of one pass.
struct PassUniforms {
    std::vector<FreeUniform> free;
    std::vector<std::string> built_in;  // built-in uniforms that it declares
    Diagnostics errors;
    Diagnostics warnings;
};

/// Checks a pass and classifies its uniforms. Built-in uniforms, inputs and those in `set` are not
/// free.
PassUniforms find_pass_uniforms(const Pass& pass, int index, CheckCache* cache);
