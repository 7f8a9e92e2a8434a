#include "io/files/temporary_file.h"

#include <fmt/format.h>

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>

namespace fs = std::filesystem;

namespace {
constexpr std::string_view name_start = ".afterglow-";
constexpr std::string_view name_end = ".tmp";

// Whether a TemporaryFile has such a name: ".afterglow-", process, "-", count, ".tmp".
bool is_temporary_name(std::string_view name) {
    if (name.size() <= name_start.size() + name_end.size() || !name.starts_with(name_start) ||
        !name.ends_with(name_end))
        return false;
    name.remove_prefix(name_start.size());
    name.remove_suffix(name_end.size());
    const std::size_t dash = name.find('-');
    const auto is_number = [](std::string_view digits) {
        return !digits.empty() && digits.find_first_not_of("0123456789") == std::string_view::npos;
    };
    return dash != std::string_view::npos && is_number(name.substr(0, dash)) &&
           is_number(name.substr(dash + 1));
}

// Whether `path` still refers to the opened file.
bool is_still(const Descriptor& opened, const fs::path& path) {
    struct stat own = {};
    struct stat named = {};
    return ::fstat(opened.get(), &own) == 0 && ::lstat(path.c_str(), &named) == 0 &&
           own.st_dev == named.st_dev && own.st_ino == named.st_ino;
}

}  // namespace

void remove_leftovers(const fs::path& folder) {
    std::error_code error;
    for (fs::directory_iterator entry(folder, error); !error && entry != fs::directory_iterator();
         entry.increment(error)) {
        const fs::path& path = entry->path();
        if (!is_temporary_name(path.filename().native()) ||
            !fs::is_regular_file(entry->symlink_status(error)))
            continue;
        const Descriptor leftover(::open(path.c_str(), O_WRONLY | O_NOFOLLOW | O_CLOEXEC));
        if (leftover.is_open() && ::flock(leftover.get(), LOCK_EX | LOCK_NB) == 0 &&
            is_still(leftover, path))
            ::unlink(path.c_str());
    }
}

TemporaryFile::TemporaryFile(const fs::path& folder) {
    static std::atomic<unsigned> counter{0};
    do {
        m_path = folder / fmt::format("{}{}-{}{}", name_start, ::getpid(), counter++, name_end);
        m_descriptor =
            Descriptor(::open(m_path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
    } while (m_descriptor.is_open() ? is_taken_away() : errno == EEXIST);
    if (is_open())
        m_scoped_file.emplace(m_path);
}

bool TemporaryFile::set_mode(mode_t mode) {
    return ::fchmod(m_descriptor.get(), mode) == 0;
}

bool TemporaryFile::write(std::string_view bytes) {
    return write_all(m_descriptor.get(), bytes);
}

bool TemporaryFile::flush() {
    return ::fsync(m_descriptor.get()) == 0;
}

bool TemporaryFile::replace_target(const fs::path& target) {
    return ::rename(m_path.c_str(), target.c_str()) == 0;
}

// The lock shows that the writer is alive, while the file has this name. Another program may have
// removed the file as a leftover before it was locked.
bool TemporaryFile::is_taken_away() {
    if (::flock(m_descriptor.get(), LOCK_EX | LOCK_NB) != 0)
        return errno == EWOULDBLOCK;  // otherwise locks are unsupported, and no program removes
                                      // leftovers
    return !is_still(m_descriptor, m_path);
}
