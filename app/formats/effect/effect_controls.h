#pragma once

#include "formats/effect/effect_names.h"
#include "model/look/look.h"

#include <string>
#include <vector>

/// A parameter of a look as one control of another program.
struct EffectControl {
    const Parameter* parameter = nullptr;
    std::string id;     // an identifier, unique
    std::string label;  // with group and unit: "Mask: Pitch (px)"
    Value value;        // the present value, for shaders
    Range range;        // includes the value; its step is above 0
};

/// The adjustable parameters that passes of the look read, in its order. Parameters in `fixed` are
/// left out, and those that are pictures, sounds or events.
std::vector<EffectControl> effect_controls(const Look& look, const Values& values,
                                           const std::vector<std::string>& fixed,
                                           EffectNames& names);

/// The text without characters that end a quoted string or a line: '"' becomes "'", and control
/// characters become spaces.
std::string quotable(std::string_view text);
