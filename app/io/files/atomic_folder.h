#pragma once

#include "base/diagnostic.h"

#include <filesystem>

/// Fills a folder under a temporary name next to its target, then renames it. The target has the
/// old or the new content, whatever fails. The destructor removes an unfinished folder. If the
/// program is killed, a hidden folder ".afterglow-XXXXXX" remains.
class AtomicFolder {
public:
    /// Missing parent folders are created. Errors name the target.
    static Result<AtomicFolder> create(const std::filesystem::path& target);
    AtomicFolder(AtomicFolder&& other) noexcept;
    AtomicFolder& operator=(AtomicFolder&&) = delete;
    ~AtomicFolder();

    /// The folder to fill.
    std::filesystem::path path() const;
    /// Renames it to the target. A folder or file that was there is removed.
    Result<void> finish();

private:
    AtomicFolder(std::filesystem::path target, std::filesystem::path workspace);

    std::filesystem::path m_target;
    std::filesystem::path m_workspace;  // "": moved away
};
