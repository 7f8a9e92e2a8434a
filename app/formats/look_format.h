#pragma once

#include "base/diagnostic.h"
#include "model/look.h"

#include <filesystem>
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

/// The look.json of a look that is named by its folder or by that file.
std::filesystem::path manifest_of(const std::filesystem::path& folder_or_manifest);

/// Reads a look: its manifest, its shaders with their includes, and its parameters, all checked.
/// `folder_or_manifest` is the look's folder, its look.json or a foreign file (of libretro, ISF,
/// Shadertoy, or a fragment shader alone); `includes` where its includes may lie besides.
LoadedLook load_look(const std::filesystem::path& folder_or_manifest,
                     const IncludeFolders& includes, const ReadingHelp& help = {});

/// Whether a file is a look of another program, by its name or, where many kinds of file have it,
/// by what it holds.
bool is_foreign_look(const std::filesystem::path& file);
/// What such a look is called in presets and stacks: its file's name, with "%2B" and "%23" in the
/// place of the signs that stacks are written with.
std::string foreign_look_id(const std::filesystem::path& file);
/// The name of the file behind such an id.
std::string foreign_file_name(std::string_view id);

/// The id of the look in a folder, manifest or foreign file, from its name alone.
std::string look_id_at(const std::filesystem::path& place);
