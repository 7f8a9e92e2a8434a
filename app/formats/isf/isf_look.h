#pragma once

#include "formats/isf/stages.h"
#include "formats/look/loaded_look.h"

/// The look that draws an ISF shader. `inputImage` of a filter and `startImage` of a transition are
/// the source; other images are a person's choice, a test pattern while there is none. Where a
/// shader listens, the sound drives the look and its `inputImage` is one of those choices. A pass
/// reads what is drawn before it, of persistent targets else the frame before; what its own part of
/// the shader never reads is no input. Passes of one target are
/// passes of their own here, "t" and "t-2"; one called `picture` stretches a last pass that has a
/// size over the picture. Errors: glslang's, at the author's
/// lines; sizes that are no expressions. `files` gets the imports.
Result<Look> look_of_isf(const IsfSource& source, const IsfHeader& header, const ReadingHelp& help,
                         std::vector<std::filesystem::path>& files, Diagnostics& warnings);
