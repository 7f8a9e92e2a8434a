#pragma once

#include "formats/effect/effect_look.h"
#include "formats/effect/effect_request.h"

/// What RetroArch and other programs with libretro's slang shaders can do.
const EffectHost& slang_host();

/// Writes a look as a preset `NAME.slangp`, its shaders in `NAME_shaders/`, and their pictures. The
/// author's text and `#include` files stay; declarations change. Each shader compiles with glslang
/// for Vulkan 1.0. The error is the reason why the format can't hold the look.
Result<EffectOutput> slang_files(const EffectRequest& request);
