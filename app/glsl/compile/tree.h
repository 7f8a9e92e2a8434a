#pragma once

#include "glsl/compile/check.h"

#include <map>
#include <string>
#include <vector>

namespace glslang {
class TShader;
}

/// A value that goes from the vertex to the fragment shader.
struct Varying {
    std::string name;
    std::string type_name;
    bool is_used = false;       // read or written outside of its declaration
    bool has_location = false;  // then its name does not count
};

/// What one stage declares, read from glslang's tree.
struct StageInterface {
    std::vector<Uniform> uniforms;
    std::vector<Varying> inputs;
    std::vector<Varying> outputs;
};

/// Reads a shader that was parsed without errors; while it and its memory live. Lines of uniforms
/// come from `places` by name. `errors` gets defaults that no 32-bit float holds.
StageInterface read_tree(glslang::TShader& shader, const std::map<std::string, Location>& places,
                         Diagnostics& errors);
