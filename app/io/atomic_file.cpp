#include "io/atomic_file.h"

#include "io/descriptor.h"

#include <fmt/format.h>

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <optional>
#include <sys/file.h>
#include <sys/stat.h>

namespace fs = std::filesystem;

namespace {
std::string system_reason() {
    return std::strerror(errno);
}

// The file that a chain of links ends at, which need not exist.
Result<fs::path> target_of(fs::path file) {
    constexpr int longest_chain = 40;
    const fs::path asked = file;
    for (int i = 0; i < longest_chain; ++i) {
        std::error_code error;
        if (!fs::is_symlink(fs::symlink_status(file, error)))
            return file;
        const fs::path next = fs::read_symlink(file, error);
        if (error)
            return fail({asked, 0, "cannot be written: " + error.message()});
        file = file.parent_path() / next;
    }
    return fail({asked, 0, "cannot be written: its links go round in a circle"});
}

constexpr std::string_view name_start = ".afterglow-";
constexpr std::string_view name_end = ".tmp";

// Whether a name is one of TemporaryFile's: ".afterglow-", a process, "-", a count, ".tmp".
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

// Whether `path` still names the file that was opened.
bool is_still(const Descriptor& opened, const fs::path& path) {
    struct stat own = {};
    struct stat named = {};
    return ::fstat(opened.get(), &own) == 0 && ::lstat(path.c_str(), &named) == 0 &&
           own.st_dev == named.st_dev && own.st_ino == named.st_ino;
}

// What a program that was killed while it saved has left. Where the writer lives, in whichever
// program or container, it holds the lock.
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

// A file beside the target that is removed unless it took the target's place.
class TemporaryFile {
public:
    explicit TemporaryFile(const fs::path& folder) {
        static std::atomic<unsigned> counter{0};
        do {
            m_path = folder / fmt::format("{}{}-{}{}", name_start, ::getpid(), counter++, name_end);
            m_descriptor =
                Descriptor(::open(m_path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
        } while (m_descriptor.is_open() ? is_taken_away() : errno == EEXIST);
    }
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;
    ~TemporaryFile() {
        if (!m_path.empty())
            ::unlink(m_path.c_str());
    }

    bool is_open() const { return m_descriptor.is_open(); }
    bool set_mode(mode_t mode) { return ::fchmod(m_descriptor.get(), mode) == 0; }

    bool write(std::string_view bytes) {
        while (!bytes.empty()) {
            const ssize_t count = ::write(m_descriptor.get(), bytes.data(), bytes.size());
            if (count < 0 && errno != EINTR)
                return false;
            bytes.remove_prefix(count < 0 ? 0 : static_cast<std::size_t>(count));
        }
        return ::fsync(m_descriptor.get()) == 0;
    }

    bool take_place_of(const fs::path& target) {
        if (::rename(m_path.c_str(), target.c_str()) != 0)
            return false;
        m_path.clear();
        return true;
    }

private:
    // The lock says for as long as the file has this name that its writer lives. Another program
    // may have come before it and have taken the file for a leftover.
    bool is_taken_away() {
        if (::flock(m_descriptor.get(), LOCK_EX | LOCK_NB) != 0)
            return errno == EWOULDBLOCK;  // else there are no locks here, and nobody clears up
        return !is_still(m_descriptor, m_path);
    }

    fs::path m_path;
    Descriptor m_descriptor;
};

// The rename itself must reach the disk; file systems that cannot say so (EINVAL) are no error.
bool flush_folder(const fs::path& folder) {
    const Descriptor descriptor(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    return !descriptor.is_open() || ::fsync(descriptor.get()) == 0 || errno == EINVAL;
}

// The permissions to keep, nothing for a new file, or why `target` must not be replaced.
Result<std::optional<mode_t>> mode_to_keep(const fs::path& file, const fs::path& target) {
    struct stat status = {};
    if (::stat(target.c_str(), &status) != 0)
        return std::nullopt;
    if (S_ISDIR(status.st_mode))
        return fail({file, 0, "cannot be written: it is a folder"});
    if (!S_ISREG(status.st_mode))
        return fail({file, 0, "cannot be written: it is not a regular file"});
    if (::access(target.c_str(), W_OK) != 0)
        return fail({file, 0, "cannot be written: " + system_reason()});
    return status.st_mode & 07777;
}
}  // namespace

Result<void> check_writable(const fs::path& file) {
    const auto target = target_of(file);
    if (!target)
        return fail(target.error());
    if (const auto mode = mode_to_keep(file, *target); !mode)
        return fail(mode.error());
    fs::path folder = fs::absolute(*target).parent_path();
    std::error_code error;
    while (!fs::exists(folder, error) && folder.has_relative_path())
        folder = folder.parent_path();
    if (!fs::is_directory(folder, error))
        return fail({file, 0, "cannot be written: '" + folder.string() + "' is not a folder"});
    if (::access(folder.c_str(), W_OK | X_OK) != 0)
        return fail({file, 0, "cannot be written: " + system_reason()});
    return {};
}

Result<void> write_atomically(const fs::path& file, std::string_view bytes) {
    if (!file.has_filename())
        return fail({file, 0, "cannot be written: it has no file name"});
    const auto target = target_of(file);
    if (!target)
        return fail(target.error());
    const auto mode = mode_to_keep(file, *target);
    if (!mode)
        return fail(mode.error());
    const fs::path folder = target->has_parent_path() ? target->parent_path() : fs::path(".");
    std::error_code error;
    fs::create_directories(folder, error);
    if (error)
        return fail({file, 0, "its folder cannot be made: " + error.message()});

    const auto refused = [&] { return fail({file, 0, "cannot be written: " + system_reason()}); };
    remove_leftovers(folder);
    TemporaryFile temporary(folder);
    if (!temporary.is_open() || (*mode && !temporary.set_mode(**mode)))
        return refused();
    if (!temporary.write(bytes) || !temporary.take_place_of(*target) || !flush_folder(folder))
        return refused();
    return {};
}
