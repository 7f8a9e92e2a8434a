#pragma once

#include "formats/slang/settings.h"

/// A preset with the files that it refers to.
struct SlangChain {
    SlangSettings owner;  // the one with `shaders`: it alone says what the passes and textures are
    std::vector<SlangSettings> changes;  // of values and texture paths; the later one wins
};

/// Follows the `#reference` lines of `file`. The first one of each file leads on, to the owner.
/// Those that follow name files of values only. Changes are applied from the deepest file to the
/// opened one, and in a file in the order of its lines, itself last. A path may have wildcards
/// (wildcards.h). A missing file of values is a warning.
/// Errors stand at the line that refers: a missing file that leads to passes, a circle, more than
/// 16 deep, more than 256 files, more than 8 MiB in all, passes in a file that may only have
/// values; at line 1 of the file where the chain ends without passes.
Result<SlangChain> read_slang_chain(const std::filesystem::path& file, SlangFiles& files,
                                    Diagnostics& warnings);
