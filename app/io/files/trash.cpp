#include "io/files/trash.h"

#include "base/file_uri.h"
#include "io/system/local_time.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace fs = std::filesystem;

namespace {
fs::path home_trash() {
    if (const char* data = std::getenv("XDG_DATA_HOME"); data && *data == '/')
        return fs::path(data) / "Trash";
    const char* home = std::getenv("HOME");
    return fs::path(home && *home ? home : "/") / ".local/share/Trash";
}

// The mount point of a file's volume.
fs::path top_of_volume(const fs::path& file) {
    struct stat here = {};
    struct stat above = {};
    fs::path top = file.parent_path();
    while (top.has_relative_path() && ::stat(top.c_str(), &here) == 0 &&
           ::stat(top.parent_path().c_str(), &above) == 0 && here.st_dev == above.st_dev)
        top = top.parent_path();
    return top;
}

std::string info_text(const fs::path& path) {
    return fmt::format("[Trash Info]\nPath={}\nDeletionDate={:%Y-%m-%dT%H:%M:%S}\n",
                       percent_encoded(path.string()), local_time(std::time(nullptr)));
}

// Creating the info file reserves the name in both folders.
Result<fs::path> reserve_name(const fs::path& trash, const fs::path& file,
                              const std::string& text) {
    constexpr int max_tries = 10000;
    for (int i = 1; i < max_tries; ++i) {
        const std::string number = i == 1 ? "" : fmt::format(" {}", i);
        const fs::path info =
            trash / "info" /
            (file.stem().string() + number + file.extension().string() + ".trashinfo");
        const int descriptor = ::open(info.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
        if (descriptor < 0 && errno == EEXIST)
            continue;
        if (descriptor < 0)
            return fail({info, 0, std::strerror(errno)});
        const bool is_written =
            ::write(descriptor, text.data(), text.size()) == static_cast<ssize_t>(text.size());
        const bool is_closed = ::close(descriptor) == 0;
        if (is_written && is_closed)
            return info;
        ::unlink(info.c_str());
        return fail({info, 0, "can't write the file"});
    }
    return fail({trash, 0, "the trash contains too many files with this name"});
}

// `recorded`: the path for the info file.
Result<TrashedFile> move_into(const fs::path& trash, const fs::path& file,
                              const fs::path& recorded) {
    std::error_code error;
    for (const char* part : {"files", "info"})
        if (fs::create_directories(trash / part, error); error)
            return fail({trash / part, 0, error.message()});
    ::chmod(trash.c_str(), 0700);
    const auto info = reserve_name(trash, file, info_text(recorded));
    if (!info)
        return fail(info.error());
    const fs::path moved = trash / "files" / info->stem();
    fs::rename(file, moved, error);
    if (!error)
        return TrashedFile{file, moved, *info};
    ::unlink(info->c_str());
    return fail({file, 0, error.message()});
}
}  // namespace

Result<TrashedFile> move_to_trash(const fs::path& given) {
    std::error_code error;
    const fs::path file = fs::absolute(given, error).lexically_normal();
    if (!fs::exists(fs::symlink_status(file, error)))
        return fail({file, 0, "file not found"});
    if (auto moved = move_into(home_trash(), file, file))
        return moved;
    const fs::path top = top_of_volume(file);
    auto moved =
        move_into(top / fmt::format(".Trash-{}", ::getuid()), file, file.lexically_relative(top));
    if (moved)
        return moved;
    return fail(
        {file, 0,
         fmt::format("can't move the file to the trash: {}", moved.error().front().message)});
}

Result<void> restore_from_trash(const TrashedFile& trashed) {
    std::error_code error;
    if (fs::exists(fs::symlink_status(trashed.original, error)))
        return fail({trashed.original, 0,
                     "a new file with this name exists. The deleted file is still in the trash."});
    fs::create_directories(trashed.original.parent_path(), error);
    fs::rename(trashed.file, trashed.original, error);
    if (error)
        return fail({trashed.original, 0,
                     fmt::format("can't restore the file from the trash: {}", error.message())});
    fs::remove(trashed.info, error);
    return {};
}
