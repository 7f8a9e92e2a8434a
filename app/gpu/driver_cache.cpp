#include "gpu/driver_cache.h"

#include <filesystem>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

namespace fs = std::filesystem;

namespace gpu {

namespace {
// Mesa calls them "PROCESS:disk$0".
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

// Asleep until there is something to write: "NUMBER (NAME) S ...".
bool rests(const fs::path& thread) {
    std::string line;
    std::getline(std::ifstream(thread / "stat"), line);
    const auto name_end = line.rfind(')');
    return name_end == std::string::npos || line.substr(name_end).starts_with(") S");
}
}  // namespace

void wait_for_driver_cache(std::chrono::milliseconds most, const PassProgress& progress) {
    const auto end = std::chrono::steady_clock::now() + most;
    for (const fs::path& thread : cache_threads())
        while (!rests(thread) && !progress.is_cancelled() && std::chrono::steady_clock::now() < end)
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

}  // namespace gpu
