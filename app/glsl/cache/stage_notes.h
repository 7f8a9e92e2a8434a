#pragma once

#include "glsl/annotations/hint.h"
#include "glsl/constants/constants.h"

#include <string>
#include <vector>

/// What the comments behind a uniform ask for.
struct UniformNotes {
    std::string name;
    Location declared;
    Hints hints;
    Diagnostics errors;  // in the hints
};

/// What the comments of a stage ask for.
struct StageNotes {
    std::vector<WrittenConstant> constants;
    std::vector<UniformNotes> uniforms;  // those with hints or with errors in them
};

StageNotes find_notes(const Stage& stage);
