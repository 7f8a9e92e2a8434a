#pragma once

#include "glsl/compile/check.h"

#include <map>
#include <string>
#include <vector>

namespace glslang {
class TShader;
}

/// A value passed from the vertex to the fragment shader.
struct Varying {
    std::string name;
    std::string type_name;
    bool is_used = false;       // read or written outside its declaration
    bool has_location = false;  // matched by location instead of name
};

/// The declarations of one stage, from glslang's tree.
struct StageInterface {
    std::vector<Uniform> uniforms;
    std::vector<Varying> inputs;
    std::vector<Varying> outputs;
};

/// Reads a shader that was parsed without errors; it and its memory pool must still exist. Lines of
/// uniforms come from `locations` by name. `errors` receives defaults that do not fit a 32-bit
/// float.
StageInterface read_tree(glslang::TShader& shader, const std::map<std::string, Location>& locations,
                         Diagnostics& errors);
