#pragma once

#include "base/diagnostic.h"
#include "model/look/look.h"

#include <string>
#include <vector>

/// What a fragment shader reads from a vertex shader that it comes without.
struct BareVarying {
    std::string type;       // "vec2"; of an interface block its name
    std::string name;       // of a block that of the instance, "": none
    std::string size = {};  // of an array in its brackets: "[5]"
    bool is_flat = false;
    int line = 1;
    std::vector<BareVarying> members = {};  // of a block
};

/// Those that a text declares, as `in`, `varying` or by a macro that is one of them, each once.
std::vector<BareVarying> find_varyings(std::string_view text);

/// A vertex stage that gives them over one triangle: two components are the place in the picture,
/// (0,0) bottom left; a colour is white; a normal looks at us. Its lines are written where `stage`
/// declares them. `warnings` gets, at those lines, what had to be guessed.
Stage vertex_stage_for(const std::vector<BareVarying>& varyings, const Stage& stage,
                       Diagnostics& warnings);
