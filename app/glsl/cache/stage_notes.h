#pragma once

#include "glsl/annotations/hint.h"
#include "glsl/constants/constants.h"

#include <string>
#include <vector>

/// The annotations in the comments of a uniform.
struct UniformNotes {
    std::string name;
    Location declared;
    Hints hints;
    Diagnostics errors;  // errors in the hints
};

/// The annotations in the comments of a stage.
struct StageNotes {
    std::vector<WrittenConstant> constants;
    std::vector<UniformNotes> uniforms;  // with hints, or with errors in hints
};

StageNotes find_notes(const Stage& stage);
