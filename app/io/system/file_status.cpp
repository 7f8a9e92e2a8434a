#include "io/system/file_status.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

bool is_writable(const std::filesystem::path& path) {
    return ::faccessat(AT_FDCWD, path.c_str(), W_OK, AT_EACCESS) == 0;
}

std::optional<FileStamp> read_file_stamp(const std::filesystem::path& file) {
    struct stat status = {};
    if (::stat(file.c_str(), &status) != 0)
        return std::nullopt;
    return FileStamp{.device = status.st_dev,
                     .number = status.st_ino,
                     .bytes = static_cast<std::uint64_t>(status.st_size),
                     .modified = {status.st_mtim.tv_sec, status.st_mtim.tv_nsec},
                     .changed = {status.st_ctim.tv_sec, status.st_ctim.tv_nsec}};
}
