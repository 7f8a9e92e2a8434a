#pragma once

#include "base/diagnostic.h"

#include <filesystem>
#include <memory>
#include <string_view>

class TemporaryFile;

/// Temporary files of a program that was killed while saving (".afterglow-PROCESS-COUNT.tmp").
/// `left` is for further saves to a folder that was already cleaned.
enum class Leftovers { removed, left };

/// Writes a file under a temporary name and renames it when complete. At any time, also after a
/// crash, the path has the old or the new content. Missing folders are created, symbolic links are
/// followed, and permissions are kept. An unfinished file is removed by the destructor, or when a
/// signal such as Ctrl+C ends the program.
class AtomicFile {
public:
    /// Rejects a path that is not a regular file or is read-only. Removes only leftovers that no
    /// program is writing.
    static Result<AtomicFile> create(const std::filesystem::path& file,
                                     Leftovers leftovers = Leftovers::removed);
    AtomicFile(AtomicFile&& other) noexcept;
    AtomicFile& operator=(AtomicFile&& other) noexcept;
    ~AtomicFile();

    /// The open file, for another program to write to.
    int descriptor() const;
    Result<void> write(std::string_view bytes);
    /// Flushes the file and renames it to its path.
    Result<void> finish();

private:
    AtomicFile(std::filesystem::path file, std::filesystem::path target,
               const std::filesystem::path& folder);
    tl::unexpected<Diagnostics> refused() const;

    std::filesystem::path m_file;  // as requested
    std::filesystem::path m_target;
    std::filesystem::path m_folder;
    std::unique_ptr<TemporaryFile> m_temporary;
};

/// Replaces the content of `file` by `bytes` in one step, with an AtomicFile.
Result<void> write_atomically(const std::filesystem::path& file, std::string_view bytes,
                              Leftovers leftovers = Leftovers::removed);

/// The same with the content of another file of any size, without holding it in memory.
Result<void> copy_atomically(const std::filesystem::path& from, const std::filesystem::path& to);

/// Whether write_atomically could write `file`, as far as can be checked in advance. For use before
/// long work whose result goes there.
Result<void> check_writable(const std::filesystem::path& file);
