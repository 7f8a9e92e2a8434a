#pragma once

#include "io/files/file_watcher.h"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

/// Watches the files of the open look, and extra files: the preset, its media.
class WatchedFiles {
public:
    WatchedFiles();

    void watch_look(const std::vector<std::filesystem::path>& files);
    void watch_extra(std::vector<std::filesystem::path> files);
    /// Watches one more extra file, until the next watch_extra().
    void add_extra(const std::filesystem::path& file);
    const std::vector<std::filesystem::path>& look_files() const { return m_look_files; }

    struct Changes {
        std::filesystem::path look_file;  // the last one that changed; "": none
        std::vector<std::filesystem::path> extra;
    };
    /// Since the last call.
    Changes take_changes();
    /// Why files are not watched, once for each failure; "": no failure.
    std::string take_problem() { return std::exchange(m_problem, {}); }
    /// Becomes readable when a file has changed; -1 if files cannot be watched.
    int descriptor() const { return m_watcher ? m_watcher->descriptor() : -1; }

private:
    void watch_all();

    std::unique_ptr<FileWatcher> m_watcher;
    std::string m_problem;
    std::vector<std::filesystem::path> m_look_files;
    std::vector<std::filesystem::path> m_extra_files;
    bool m_is_watching = false;
};
