#pragma once

#include <filesystem>
#include <utility>
#include <vector>

/// Files that the user opened and that could be read, for the list of recent files.
class OpenedFiles {
public:
    void add(std::filesystem::path file) { m_files.push_back(std::move(file)); }
    /// The files since the last call.
    std::vector<std::filesystem::path> take() { return std::exchange(m_files, {}); }

private:
    std::vector<std::filesystem::path> m_files;
};
