#pragma once

#include <algorithm>
#include <cstdint>

/// Identifies one state of a file: equal stamps mean the same content, unless the file was written
/// twice within one tick of its clock.
struct FileStamp {
    /// Since 1970.
    struct Time {
        std::int64_t seconds = 0;
        std::int64_t nanoseconds = 0;
        bool operator==(const Time&) const = default;
    };

    std::uint64_t device = 0;
    std::uint64_t number = 0;  // of the file on its device
    std::uint64_t bytes = 0;
    Time modified = {};  // its content
    Time changed = {};   // its content, name or permissions

    std::int64_t newest_seconds() const { return std::max(modified.seconds, changed.seconds); }
    bool operator==(const FileStamp&) const = default;
};
