#pragma once

#include "io/system/descriptor.h"

#include <filesystem>
#include <string_view>

/// A file that stays open and locked, so that other programs see that this one runs. The lock ends
/// with this object or with the process.
class LockedFile {
public:
    /// Not open.
    LockedFile() = default;
    /// Opens the file, and creates it if it is missing. Only this user can access a new file. Not
    /// open on failure.
    explicit LockedFile(const std::filesystem::path& file);

    bool is_open() const { return m_descriptor.is_open(); }
    /// Locks the file and replaces its content. False if it is not open, can't be written, or is
    /// locked by another program.
    bool replace(std::string_view text) const;

private:
    Descriptor m_descriptor;
};

/// Whether the file can be opened and nothing holds its lock.
bool is_unlocked(const std::filesystem::path& file);
