#pragma once

#include "formats/effect/effect_text.h"
#include "model/look/look.h"

#include <string>

/// The name of the function that vertex_function() defines.
inline constexpr const char* vertex_function_name = "afterglow_set_inputs";

/// Whether a pass has a vertex shader of its own.
bool has_own_vertex(const Pass& pass);

/// The vertex shader of a pass as GLSL for its fragment shader, whose inputs are variables:
/// `void afterglow_set_inputs(vec2 place)` sets them for a place in the target, from (0, 0) to (1,
/// 1). It evaluates three corners and interpolates between them, as rasterisers do. `fragment`: the
/// fragment shader. `rules` are those for its uniforms.
std::string vertex_function(const Pass& pass, std::string_view fragment,
                            const EffectTextRules& rules);
