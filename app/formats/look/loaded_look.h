#pragma once

#include "base/diagnostic.h"
#include "model/look/look.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

class CheckCache;
class PassProgress;
class ShaderFiles;

/// Optional inputs for loading a look; all may be null.
struct LoadOptions {
    CheckCache* cache = nullptr;       // avoids checking unchanged shaders again
    PassProgress* progress = nullptr;  // for translated looks; cancelling it makes loading fail
    const Values* values = nullptr;    // values, including those of adjustable constants
    ShaderFiles* disk = nullptr;       // avoids reading unchanged files again
    bool is_picture_driven = false;    // for a look that a signal or a picture can drive
};

/// A loaded look, or its errors.
struct LoadedLook {
    Result<Look> look;
    std::vector<std::filesystem::path>
        files;  // read or missing files for a watcher; set on failure, too
    Diagnostics warnings;
    bool is_parsed = false;  // its texts were read, even if glslang reported errors
};

/// The id of a foreign look in presets and stacks: its file name with "%2B" for '+' and "%23" for
/// '#', which separate stacks.
std::string foreign_look_id(const std::filesystem::path& file);
/// The file name of such an id.
std::string foreign_file_name(std::string_view id);
