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

/// What reading a look may be given; all may be null.
struct ReadingHelp {
    CheckCache* cache = nullptr;       // shaders that did not change are not checked again
    PassProgress* progress = nullptr;  // of looks that are translated; cancelled there, it fails
    const Values* values = nullptr;    // what constants of its texts are turned to, among others
    ShaderFiles* disk = nullptr;       // files that did not change are not looked into again
};

/// A look as it was read, or why it was not.
struct LoadedLook {
    Result<Look> look;
    std::vector<std::filesystem::path>
        files;  // read, or missed: what a watcher watches, also on failure
    Diagnostics warnings;
    bool is_parsed = false;  // its texts were read, whatever glslang said of them
};

/// What a look of another program is called in presets and stacks: its file's name, with "%2B" and
/// "%23" in the place of the signs that stacks are written with.
std::string foreign_look_id(const std::filesystem::path& file);
/// The name of the file behind such an id.
std::string foreign_file_name(std::string_view id);
