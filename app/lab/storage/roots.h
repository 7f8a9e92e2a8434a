#pragma once

#include "base/diagnostic.h"
#include "model/look/include_folders.h"
#include "model/look/shader_limits.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

/// The folders that contain `shaders/` and `presets/`: the program's, then the user's.
struct Roots {
    std::filesystem::path program;
    std::filesystem::path user;                        // $XDG_DATA_HOME/afterglow; may not exist
    std::filesystem::path state;                       // $XDG_STATE_HOME/afterglow; may not exist
    std::filesystem::path cache = {};                  // $XDG_CACHE_HOME/afterglow; may not exist
    std::vector<std::filesystem::path> includes = {};  // further include folders of the user
    ShaderLimits shader_limits = {};                   // of all looks
    std::filesystem::path config = {};                 // $XDG_CONFIG_HOME/afterglow; "": none
    int instance = 1;                                  // of the window; see instance_lock.h

    std::vector<std::filesystem::path> all() const { return {program, user}; }
    IncludeFolders include_folders() const { return {program / "shaders" / "include", includes}; }
};

/// The options of the command line for folders and shader limits.
struct DataFolders {
    std::string data = {};                      // of --data; "": not given
    std::vector<std::string> includes = {};     // of --include, in order
    ShaderLimits limits = {};                   // of --limit
    std::vector<std::string> limit_texts = {};  // of --limit, as given
};

/// The folders that may have the program's looks and documentation, in the order of search: those
/// above the program, each followed by its share/afterglow, and the source tree.
std::vector<std::filesystem::path> program_folders();

/// Uses `data` (from --data) or $AFTERGLOW_DATA. Otherwise the first folder that contains
/// `shaders/`: above the program, its share/afterglow, the source tree. Fails if `shaders/` is
/// missing, or if one of `includes` is not a folder.
Result<Roots> find_roots(const std::optional<std::filesystem::path>& data,
                         const std::vector<std::string>& includes = {});
