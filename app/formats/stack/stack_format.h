#pragma once

#include "formats/look_format.h"

/// Loads the looks of a stack, each once, and combines them into one. A single look is returned
/// unchanged. Missing ids and tags of parts are filled in. The rest of `stack` becomes Look::stack.
/// Like load_look().
LoadedLook load_stack(Stack stack, const IncludeFolders& includes, const LoadOptions& help = {});

/// Reloads a look returned by load_stack(), for other values of its constants or other settings of
/// its parts. Without a cache, the original shader limits apply.
LoadedLook load_again(const Look& look, const Stack& stack, const LoadOptions& help);
