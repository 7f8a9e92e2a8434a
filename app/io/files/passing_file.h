#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

/// A file that is removed with its owner, and also when a signal such as Ctrl+C ends the program.
/// On any thread.
class PassingFile {
public:
    explicit PassingFile(const std::filesystem::path& file);
    ~PassingFile();
    PassingFile(const PassingFile&) = delete;
    PassingFile& operator=(const PassingFile&) = delete;

private:
    std::string m_name;
    std::size_t m_slot = 0;  // where the handler finds the name
};
