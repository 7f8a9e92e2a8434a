#pragma once

#include "io/files/descriptor.h"
#include "io/files/passing_file.h"

#include <filesystem>
#include <optional>
#include <string_view>
#include <sys/types.h>

/// A file beside another one, whose place it may take; else it goes with its owner. Where something
/// fails errno says why.
class TemporaryFile {
public:
    explicit TemporaryFile(const std::filesystem::path& folder);

    bool is_open() const { return m_descriptor.is_open(); }
    int descriptor() const { return m_descriptor.get(); }
    bool set_mode(mode_t mode);
    bool write(std::string_view bytes);
    /// What was written reaches the disk.
    bool flush();
    bool take_place_of(const std::filesystem::path& target);

private:
    bool is_taken_away();

    std::filesystem::path m_path;
    Descriptor m_descriptor;
    std::optional<PassingFile> m_passing;  // no other file is ever given this name
};

/// Removes what programs that were killed while they saved have left in a folder. Where the writer
/// lives, in whichever program or container, it holds the file's lock.
void remove_leftovers(const std::filesystem::path& folder);
