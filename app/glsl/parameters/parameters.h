#pragma once

#include "glsl/cache/check_cache.h"
#include "glsl/compile/check.h"
#include "model/look/look.h"

#include <vector>

/// Every parameter of the look that is a uniform, in order of declaration; the look may have its
/// constants already. Checks all passes with glslang, reads
/// annotations, makes one parameter of one uniform name in several passes, applies each pass's
/// `set` (no parameter there) and `rename`. Built-in uniforms are no parameters; a sampler2D
/// without an input is a picture to be chosen. Errors: shader errors; mistakes in annotations;
/// declarations that disagree, on the second one's line; at the pass's place in look.json what
/// `set`, `rename` and `inputs` name and no shader of the pass declares; other samplers without an
/// input. `warnings` gets uniforms that cannot have a control, with the reason, and glslang's own.
/// `cache` may be null.
Result<std::vector<Parameter>> find_parameters(const Look& look, CheckCache* cache,
                                               Diagnostics& warnings);
