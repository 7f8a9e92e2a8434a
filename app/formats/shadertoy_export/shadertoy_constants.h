#pragma once

#include "formats/effect/effect_controls.h"

#include <string>
#include <vector>

/// A parameter as constants of a shader. Their comments have annotations, which Afterglow reads.
struct ShadertoyConstant {
    EffectControl control;
    std::vector<std::string> names;  // one per component: "tint_x"
    bool is_plain = false;           // the author's annotation is valid for it
    std::string text;                // the lines that declare it, with annotations
};

/// The constants of the look's controls.
std::vector<ShadertoyConstant> shadertoy_constants(const Look& look,
                                                   std::vector<EffectControl> controls,
                                                   EffectNames& names);
