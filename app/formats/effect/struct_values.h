#pragma once

#include "formats/glsl/modern_glsl.h"
#include "model/look/look.h"

#include <string>
#include <vector>

/// A variable of a pass that is a struct.
struct StructValue {
    std::string name;
    std::string type;
    std::string members;  // arguments of its constructor
};

/// Statements that give these values to the variables of a pass. Each stage may declare its own.
/// `words`: the new names of the fragment shader. `vertex_prefix`: of the names of the vertex
/// shader; "": it has none of its own.
std::string struct_settings(const Pass& pass, const std::vector<StructValue>& structs,
                            const WordChanges& words, const std::string& vertex_prefix);

/// What a shader reads and writes, with its new names. "": nothing.
struct ShaderEnds {
    std::string input;
    std::string output;
};
/// The last input and output that a fragment shader declares.
ShaderEnds ends_of_shader(const std::string& fragment, const WordChanges& words);
