#pragma once

#include "formats/effect/effect_look.h"
#include "formats/effect/effect_request.h"

/// What mpv's user shaders can do.
const EffectHost& mpv_host();

/// Writes a look as one user shader `NAME.glsl`: a block per pass and mip level, with the author's
/// text. Values are `#define` lines, or PARAM blocks if the request has live parameters. The error
/// is the reason why mpv can't draw the look.
Result<EffectOutput> mpv_files(const EffectRequest& request);
