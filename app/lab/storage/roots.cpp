#include "lab/storage/roots.h"

#include "base/font_file.h"
#include "base/user_folders.h"
#include "io/system/process.h"

#include <cstdlib>

namespace fs = std::filesystem;

namespace {
bool holds_shaders(const fs::path& folder) {
    std::error_code error;
    return fs::is_directory(folder / "shaders", error);
}
}  // namespace

std::vector<fs::path> program_folders() {
    std::vector<fs::path> folders;
    for (fs::path folder = program_file().parent_path(); folder.has_relative_path();
         folder = folder.parent_path()) {
        folders.push_back(folder);
        folders.push_back(folder / "share" / "afterglow");
    }
    if (const fs::path source = AFTERGLOW_SOURCE_DIR; !source.empty())
        folders.push_back(source);
    return folders;
}

Result<Roots> find_roots(const std::optional<fs::path>& data,
                         const std::vector<std::string>& includes) {
    Roots roots;
    for (const std::string& include : includes) {
        std::error_code error;
        if (!fs::is_directory(include, error))
            return fail(
                {include, 0, "is not a folder. --include takes a folder of shader includes."});
        roots.includes.push_back(fs::absolute(include).lexically_normal());
    }
    roots.user = folder_from_environment("XDG_DATA_HOME", ".local/share");
    roots.state = folder_from_environment("XDG_STATE_HOME", ".local/state");
    roots.config = folder_from_environment("XDG_CONFIG_HOME", ".config");
    roots.cache = folder_from_environment("XDG_CACHE_HOME", ".cache");
    const char* variable = std::getenv("AFTERGLOW_DATA");
    if (data || (variable && *variable)) {
        roots.program = data ? *data : fs::path(variable);
        if (!holds_shaders(roots.program))
            return fail({roots.program, 0, "is not a data folder: it has no folder 'shaders'"});
        roots.program = fs::absolute(roots.program).lexically_normal();
        return roots;
    }
    for (const fs::path& folder : program_folders()) {
        if (holds_shaders(folder)) {
            roots.program = folder;
            set_own_fonts(folder / "fonts");
            return roots;
        }
    }
    return fail(
        {{}, 0, "the looks were not found next to the program. Set their folder with --data."});
}
