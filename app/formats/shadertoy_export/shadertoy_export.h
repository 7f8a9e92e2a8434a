#pragma once

#include "formats/effect/effect_look.h"
#include "formats/effect/effect_request.h"

/// What Shadertoy can do.
const EffectHost& shadertoy_host();

/// Writes a look as a Shadertoy shader, `NAME.json`, in the form of the site's exports: buffers and
/// an image with the author's text, and parameters as constants with annotations. All passes are
/// valid GLSL ES 3.00. The error is the reason why Shadertoy can't hold the look.
Result<EffectOutput> shadertoy_files(const EffectRequest& request);
