#pragma once

#include "formats/slang/settings.h"

/// A preset with the files that it references.
struct SlangChain {
    SlangSettings owner;  // the file with `shaders`; it alone defines the passes and textures
    std::vector<SlangSettings> changes;  // of values and texture paths; the last one wins
};

/// Follows the `#reference` lines of `file`. The first one in each file leads to the owner; the
/// others name files of values only. Changes apply from the deepest file to the opened one, and
/// within a file in line order, its own settings last. A path may have wildcards (wildcards.h). A
/// missing file of values is a warning.
/// Errors, at the line of the reference: a missing file that leads to passes, a circular reference,
/// passes in a file of values, exceeded limits. Limits: 16 levels, 256 files, 8 MiB in total. Error
/// at line 1 of the last file: a chain without passes.
Result<SlangChain> read_slang_chain(const std::filesystem::path& file, SlangFiles& files,
                                    Diagnostics& warnings);
