#pragma once

#include "formats/effect/effect_look.h"
#include "formats/effect/effect_request.h"

/// What effects of ReShade and vkBasalt can do.
const EffectHost& reshade_host();

/// Writes a look as an effect `NAME.fx` of ReShade and vkBasalt. The folder `NAME_reshade/` has a
/// preset `NAME.ini`, the settings `vkBasalt.conf` and the pictures of the look. Shaders are
/// translated to HLSL. The error is the reason why the format can't hold the look.
Result<EffectOutput> reshade_files(const EffectRequest& request);
