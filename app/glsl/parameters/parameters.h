#pragma once

#include "glsl/cache/check_cache.h"
#include "glsl/compile/check.h"
#include "model/look/look.h"

#include <vector>

/// All uniform parameters of the look, in order of declaration. The look may already have its
/// constants.
/// Checks all passes with glslang and reads the annotations. A uniform name in several passes is
/// one parameter. Applies each pass's `set` (no parameter in that pass) and `rename`. Built-in
/// uniforms are not parameters. A sampler2D without an input is a picture parameter.
/// Errors: shader errors; annotation errors; conflicting declarations, on the second one's line;
/// names in `set`, `rename` and `inputs` that no shader of the pass declares, at the pass in
/// look.json; other samplers without an input. `warnings` receives uniforms that cannot have a
/// control, with the reason, and glslang's warnings. `cache` may be null.
Result<std::vector<Parameter>> find_parameters(const Look& look, CheckCache* cache,
                                               Diagnostics& warnings);
