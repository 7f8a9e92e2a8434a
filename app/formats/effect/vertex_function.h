#pragma once

#include "formats/effect/effect_text.h"
#include "model/look/look.h"

#include <string>

/// Whether a pass has a vertex shader of its own.
bool has_own_vertex(const Pass& pass);

/// A vertex shader as functions of a fragment shader.
struct VertexFunction {
    std::string name;    // void NAME(vec2 place)
    std::string prefix;  // of the vertex shader's names
    std::string text;
};

/// The vertex shader of a pass for its fragment shader, whose inputs are variables. The function
/// sets them for a place in the target, from (0, 0) to (1, 1). It evaluates three corners and
/// interpolates between them, as rasterisers do. `fragment`: the fragment shader. `rules`: the
/// uniforms of both, and the new names of the fragment shader's words. `prefix`: the wanted one.
VertexFunction vertex_function(const Pass& pass, std::string_view fragment,
                               const EffectTextRules& rules, const std::string& prefix = "vertex_");
