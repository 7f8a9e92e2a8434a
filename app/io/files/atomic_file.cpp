#include "io/files/atomic_file.h"

#include "io/files/temporary_file.h"
#include "io/system/descriptor.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <fstream>
#include <optional>
#include <sys/stat.h>

namespace fs = std::filesystem;

namespace {
tl::unexpected<Diagnostics> unwritable(const fs::path& file, const std::string& reason) {
    return fail({file, 0, fmt::format("can't write the file: {}", reason)});
}

std::string system_reason() {
    return std::strerror(errno);
}

// The target of a chain of symbolic links, which need not exist.
Result<fs::path> target_of(fs::path file) {
    constexpr int longest_chain = 40;
    const fs::path asked = file;
    for (int i = 0; i < longest_chain; ++i) {
        std::error_code error;
        if (!fs::is_symlink(fs::symlink_status(file, error)))
            return file;
        const fs::path next = fs::read_symlink(file, error);
        if (error)
            return unwritable(asked, error.message());
        file = file.parent_path() / next;
    }
    return unwritable(asked, "its symbolic links form a loop");
}

// Makes the rename durable. On failure the new file is still in place and flushed. Only a power
// loss could restore the old one, so this is not an error.
void flush_folder(const fs::path& folder) {
    const Descriptor descriptor(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (descriptor.is_open())
        static_cast<void>(::fsync(descriptor.get()));
}

// The permissions to keep, nullopt for a new file, or the reason why `target` can't be replaced.
Result<std::optional<mode_t>> mode_to_keep(const fs::path& file, const fs::path& target) {
    struct stat status = {};
    if (::stat(target.c_str(), &status) != 0)
        return std::nullopt;
    if (S_ISDIR(status.st_mode))
        return unwritable(file, "it is a folder");
    if (!S_ISREG(status.st_mode))
        return unwritable(file, "it isn't a regular file");
    if (::access(target.c_str(), W_OK) != 0)
        return unwritable(file, system_reason());
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
        return unwritable(file, fmt::format("'{}' isn't a folder", folder.string()));
    if (::access(folder.c_str(), W_OK | X_OK) != 0)
        return unwritable(file, system_reason());
    return {};
}

AtomicFile::AtomicFile(fs::path file, fs::path target, const fs::path& folder)
    : m_file(std::move(file)),
      m_target(std::move(target)),
      m_folder(folder),
      m_temporary(std::make_unique<TemporaryFile>(folder)) {}

AtomicFile::AtomicFile(AtomicFile&& other) noexcept = default;
AtomicFile& AtomicFile::operator=(AtomicFile&& other) noexcept = default;
AtomicFile::~AtomicFile() = default;

Result<AtomicFile> AtomicFile::create(const fs::path& file, Leftovers leftovers) {
    if (!file.has_filename())
        return unwritable(file, "the path has no file name");
    auto target = target_of(file);
    if (!target)
        return fail(target.error());
    const auto mode = mode_to_keep(file, *target);
    if (!mode)
        return fail(mode.error());
    const fs::path folder = target->has_parent_path() ? target->parent_path() : fs::path(".");
    std::error_code error;
    fs::create_directories(folder, error);
    if (error)
        return fail({file, 0, fmt::format("can't create its folder: {}", error.message())});
    if (leftovers == Leftovers::removed)
        remove_leftovers(folder);
    AtomicFile made(file, std::move(*target), folder);
    if (!made.m_temporary->is_open() || (*mode && !made.m_temporary->set_mode(**mode)))
        return made.refused();
    return made;
}

tl::unexpected<Diagnostics> AtomicFile::refused() const {
    return unwritable(m_file, system_reason());
}

int AtomicFile::descriptor() const {
    return m_temporary->descriptor();
}

Result<void> AtomicFile::write(std::string_view bytes) {
    if (!m_temporary->write(bytes))
        return refused();
    return {};
}

Result<void> AtomicFile::finish() {
    if (!m_temporary->flush() || !m_temporary->replace_target(m_target))
        return refused();
    flush_folder(m_folder);
    return {};
}

Result<void> write_atomically(const fs::path& file, std::string_view bytes, Leftovers leftovers) {
    auto written = AtomicFile::create(file, leftovers);
    if (!written)
        return fail(written.error());
    if (auto done = written->write(bytes); !done)
        return done;
    return written->finish();
}

Result<void> copy_atomically(const fs::path& from, const fs::path& to) {
    std::ifstream source(from, std::ios::binary);
    if (!source)
        return fail({from, 0, fmt::format("can't read the file: {}", system_reason())});
    auto copy = AtomicFile::create(to);
    if (!copy)
        return fail(copy.error());
    std::string part(std::size_t{1} << 20, '\0');
    while (source.read(part.data(), static_cast<std::streamsize>(part.size())) ||
           source.gcount() > 0)
        if (auto written = copy->write({part.data(), static_cast<std::size_t>(source.gcount())});
            !written)
            return written;
    if (source.bad())
        return fail({from, 0, fmt::format("can't read the file: {}", system_reason())});
    return copy->finish();
}
