#pragma once

#include "base/diagnostic.h"
#include "model/look/include_folders.h"
#include "model/look/shader_limits.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

/// The folders that hold `shaders/` and `presets/`: the program's root, then the person's own.
struct Roots {
    std::filesystem::path program;
    std::filesystem::path user;                        // $XDG_DATA_HOME/afterglow; need not exist
    std::filesystem::path state;                       // $XDG_STATE_HOME/afterglow; need not exist
    std::filesystem::path cache = {};                  // $XDG_CACHE_HOME/afterglow; need not exist
    std::vector<std::filesystem::path> includes = {};  // named for includes, besides the program's
    ShaderLimits shader_limits = {};                   // of the looks that are opened

    std::vector<std::filesystem::path> all() const { return {program, user}; }
    IncludeFolders include_folders() const { return {program / "shaders" / "include", includes}; }
};

/// What the command line says about folders, and about the looks in them.
struct DataFolders {
    std::string data = {};                      // of --data; "": not given
    std::vector<std::string> includes = {};     // of --include, in order
    ShaderLimits limits = {};                   // of --limit
    std::vector<std::string> limit_texts = {};  // of --limit, as given
};

/// `data` (from --data), $AFTERGLOW_DATA, a folder above the program that holds shaders/ (or its
/// share/afterglow), the source tree: the first that holds `shaders/`. An error where it does not,
/// or where one of `includes` is no folder.
Result<Roots> find_roots(const std::optional<std::filesystem::path>& data,
                         const std::vector<std::string>& includes = {});
