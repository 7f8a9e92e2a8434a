#include "gpu/driver_cache.h"

#include <cerrno>
#include <cstdlib>
#include <fcntl.h>
#include <fstream>
#include <mutex>
#include <string>
#include <thread>
#include <unistd.h>
#include <vector>

namespace fs = std::filesystem;

namespace gpu {

namespace {
// Mesa's cache threads are named "PROCESS:disk$0".
bool writes_cache(const fs::path& thread) {
    std::string name;
    std::getline(std::ifstream(thread / "comm"), name);
    return name.find(":disk$") != std::string::npos;
}

std::vector<fs::path> cache_threads() {
    std::vector<fs::path> found;
    std::error_code none;
    for (fs::directory_iterator it("/proc/self/task", none), end; !none && it != end;
         it.increment(none))
        if (writes_cache(it->path()))
            found.push_back(it->path());
    return found;
}

// Whether the thread sleeps, so has no writes left: "NUMBER (NAME) S ...".
bool is_idle(const fs::path& thread) {
    std::string line;
    std::getline(std::ifstream(thread / "stat"), line);
    const auto name_end = line.rfind(')');
    return name_end == std::string::npos || line.substr(name_end).starts_with(") S");
}
}  // namespace

namespace {
// Mesa's search order: docs/envvars.rst.
fs::path driver_cache_folder() {
    for (const char* name : {"MESA_SHADER_CACHE_DIR", "MESA_GLSL_CACHE_DIR"})
        if (const char* folder = std::getenv(name); folder && *folder)
            return folder;
    if (const char* folder = std::getenv("XDG_CACHE_HOME"); folder && *folder)
        return folder;
    const char* const home = std::getenv("HOME");
    return home && *home ? fs::path(home) / ".cache" : fs::path();
}
}  // namespace

bool has_free_space(const fs::path& folder, std::size_t bytes) {
    std::error_code error;
    fs::path there = folder;
    while (!fs::is_directory(there, error) && there.has_relative_path())
        there = there.parent_path();
    // An unnamed file; closing its descriptor deletes it.
    const int file = ::open(there.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, 0600);
    if (file < 0)
        return errno != ENOSPC && errno != EDQUOT;
    const int refusal = ::posix_fallocate(file, 0, static_cast<off_t>(bytes));
    ::close(file);
    return refusal != ENOSPC && refusal != EDQUOT && refusal != EFBIG;
}

void check_driver_cache() {
    // Mesa's cache index alone takes 1.3 MB.
    constexpr std::size_t enough_bytes = std::size_t{8} << 20;
    static std::once_flag once;
    std::call_once(once, [] {
        const fs::path folder = driver_cache_folder();
        if (folder.empty() || has_free_space(folder, enough_bytes))
            return;
        ::setenv("MESA_SHADER_CACHE_DISABLE", "true", 1);
        ::setenv("MESA_GLSL_CACHE_DISABLE", "true", 1);  // the name before Mesa 22
    });
}

void wait_for_driver_cache(std::chrono::milliseconds maximum, const PassProgress& progress) {
    const auto end = std::chrono::steady_clock::now() + maximum;
    for (const fs::path& thread : cache_threads())
        while (!is_idle(thread) && !progress.is_cancelled() &&
               std::chrono::steady_clock::now() < end)
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

}  // namespace gpu
