#include "base/user_folders.h"

#include <cstdlib>

namespace fs = std::filesystem;

fs::path folder_from_environment(const char* name, const char* below_home) {
    if (const char* folder = std::getenv(name); folder && *folder == '/')
        return fs::path(folder) / "afterglow";
    const char* home = std::getenv("HOME");
    return fs::path(home && *home ? home : "/") / below_home / "afterglow";
}

// Not in /tmp: another user could create the path there first.
fs::path runtime_folder() {
    if (const char* folder = std::getenv("XDG_RUNTIME_DIR"); folder && *folder == '/')
        return fs::path(folder) / "afterglow";
    return folder_from_environment("XDG_STATE_HOME", ".local/state") / "run";
}
