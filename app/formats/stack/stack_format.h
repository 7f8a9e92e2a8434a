#pragma once

#include "formats/look_format.h"

/// Reads the looks of a stack, each once, and makes them one; a look alone stays as it is. Parts
/// get the id and tag that they lack; all else of `stack` is Look::stack. As load_look.
LoadedLook load_stack(Stack stack, const IncludeFolders& includes, const ReadingHelp& help = {});

/// A look that load_stack gave, from its files again; for other values of its constants.
/// Without a cache its texts are held to the limits that it was read with.
LoadedLook load_again(const Look& look, const ReadingHelp& help);
