#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

/// A file that is removed by the destructor, and also when a signal such as Ctrl+C ends the
/// program. Thread-safe.
class ScopedFile {
public:
    explicit ScopedFile(const std::filesystem::path& file);
    ~ScopedFile();
    ScopedFile(const ScopedFile&) = delete;
    ScopedFile& operator=(const ScopedFile&) = delete;

private:
    std::string m_name;
    std::size_t m_slot = 0;  // index of the name for the signal handler
};
