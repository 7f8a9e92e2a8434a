#pragma once

#include "base/diagnostic.h"

#include <filesystem>
#include <memory>
#include <string_view>

class TemporaryFile;

/// What a program that was killed while it saved has left in a folder
/// (".afterglow-PROCESS-COUNT.tmp"): removed, or left to a save that has looked for it already.
enum class Leftovers { removed, left };

/// A file that is written beside its place and takes it when it is whole: at every moment, also
/// after a crash, there is the old one or the new one. Missing folders are made; a link's target is
/// replaced and the link stays; permissions stay. What is not finished goes with its owner, and
/// with the program when a signal such as Ctrl+C ends it.
class AtomicFile {
public:
    /// Refuses what is not a regular file and what is read-only. Of leftovers only those go that
    /// nobody is writing.
    static Result<AtomicFile> create(const std::filesystem::path& file,
                                     Leftovers leftovers = Leftovers::removed);
    AtomicFile(AtomicFile&& other) noexcept;
    AtomicFile& operator=(AtomicFile&& other) noexcept;
    ~AtomicFile();

    /// As an open file of the system, for another program to write.
    int descriptor() const;
    Result<void> write(std::string_view bytes);
    /// It is whole: flushed, and in its place.
    Result<void> finish();

private:
    AtomicFile(std::filesystem::path file, std::filesystem::path target,
               const std::filesystem::path& folder);
    tl::unexpected<Diagnostics> refused() const;

    std::filesystem::path m_file;  // as it was asked for
    std::filesystem::path m_target;
    std::filesystem::path m_folder;
    std::unique_ptr<TemporaryFile> m_temporary;
};

/// Makes `bytes` the whole content of `file` in one step, as an AtomicFile does.
Result<void> write_atomically(const std::filesystem::path& file, std::string_view bytes,
                              Leftovers leftovers = Leftovers::removed);

/// Whether write_atomically could write `file`, as far as that can be told beforehand: before long
/// work whose result it is to hold.
Result<void> check_writable(const std::filesystem::path& file);
