#pragma once

#include "formats/effect/effect_look.h"
#include "formats/effect/effect_request.h"

/// What programs with ISF shaders can do.
const EffectHost& isf_host();

/// Writes a look as one ISF file, `NAME.fs`: all passes with the author's text, and parameters as
/// INPUTS. Names that two passes declare get the name of the pass in front. The error is the reason
/// why the format can't hold the look.
Result<EffectOutput> isf_files(const EffectRequest& request);
