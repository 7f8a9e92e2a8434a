#pragma once

#include "io/files/scoped_file.h"
#include "io/system/descriptor.h"

#include <filesystem>
#include <optional>
#include <string_view>
#include <sys/types.h>

/// A temporary file in the folder of its target, which it can replace; otherwise the destructor
/// removes it. errno has the reason of a failure.
class TemporaryFile {
public:
    explicit TemporaryFile(const std::filesystem::path& folder);

    bool is_open() const { return m_descriptor.is_open(); }
    int descriptor() const { return m_descriptor.get(); }
    bool set_mode(mode_t mode);
    bool write(std::string_view bytes);
    /// Flushes written data to the disk.
    bool flush();
    bool replace_target(const std::filesystem::path& target);

private:
    bool is_taken_away();

    std::filesystem::path m_path;
    Descriptor m_descriptor;
    std::optional<ScopedFile> m_scoped_file;  // the name is never reused
};

/// Removes the temporary files in a folder whose programs were killed while saving. A living
/// writer, in any program or container, holds the file's lock.
void remove_leftovers(const std::filesystem::path& folder);
