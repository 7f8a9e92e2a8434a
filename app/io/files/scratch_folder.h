#pragma once

#include "base/diagnostic.h"

#include <filesystem>

/// A new private folder in the system's folder for temporary files. The destructor removes it with
/// its contents.
class ScratchFolder {
public:
    /// Errors name the folder for temporary files.
    static Result<ScratchFolder> create();
    ScratchFolder(ScratchFolder&& other) noexcept;
    ScratchFolder& operator=(ScratchFolder&&) = delete;
    ~ScratchFolder();

    const std::filesystem::path& path() const { return m_path; }

private:
    explicit ScratchFolder(std::filesystem::path path) : m_path(std::move(path)) {}

    std::filesystem::path m_path;  // "": moved away
};
