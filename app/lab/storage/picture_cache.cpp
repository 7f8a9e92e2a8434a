#include "lab/storage/picture_cache.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace fs = std::filesystem;

void forget_old(const fs::path& folder) {
    constexpr std::size_t maximum = 1000;  // about 16 MB
    std::vector<std::pair<fs::file_time_type, fs::path>> files;
    std::error_code error;
    for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error))
        files.emplace_back(fs::last_write_time(it->path(), error), it->path());
    if (files.size() <= maximum)
        return;
    std::ranges::sort(files);
    for (std::size_t i = 0; i + maximum < files.size(); ++i)
        fs::remove(files[i].second, error);
}
