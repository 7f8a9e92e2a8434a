#pragma once

#include "formats/isf/stages.h"
#include "formats/look/loaded_look.h"

/// The look for an ISF shader. `inputImage` of a filter and `startImage` of a transition are the
/// source. Other images are picture parameters with a test pattern as default. If a shader has a
/// sound input, the sound drives the look, and its `inputImage` is a picture parameter, too. A pass
/// reads a target as drawn earlier in the frame, otherwise a persistent target of the previous
/// frame. Targets that its part of the shader never reads are not inputs. Passes with the same
/// target become separate passes, "t" and "t-2". A last pass with its own size is stretched to the
/// picture by a pass `picture`. Errors: glslang's, at the author's lines; invalid size expressions.
/// `files` receives the imports.
Result<Look> look_of_isf(const IsfSource& source, const IsfHeader& header, const LoadOptions& help,
                         std::vector<std::filesystem::path>& files, Diagnostics& warnings);
