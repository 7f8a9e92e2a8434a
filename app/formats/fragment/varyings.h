#pragma once

#include "base/diagnostic.h"
#include "model/look/look.h"

#include <string>
#include <vector>

/// An input of a fragment shader that has no vertex shader.
struct FragmentVarying {
    std::string type;       // "vec2"; for an interface block, its name
    std::string name;       // for a block, the instance name; "": none
    std::string size = {};  // of an array, in brackets: "[5]"
    bool is_flat = false;
    int line = 1;
    std::vector<FragmentVarying> members = {};  // for a block
};

/// The varyings of a text, each once, declared with `in`, `varying` or a macro for one of these.
std::vector<FragmentVarying> find_varyings(std::string_view text);

/// A vertex stage that sets the varyings over one triangle. Two components are the position in the
/// picture, (0,0) at the bottom left. A colour is white, and a normal faces the viewer. Its lines
/// have the locations of the declarations in `stage`. `warnings` receives the guesses, at those
/// lines.
Stage vertex_stage_for(const std::vector<FragmentVarying>& varyings, const Stage& stage,
                       Diagnostics& warnings);
