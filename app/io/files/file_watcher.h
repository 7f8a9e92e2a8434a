#pragma once

#include "base/diagnostic.h"
#include "io/system/descriptor.h"

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

/// Reports which files were saved. Watches their folders to detect saves in place, saves by rename
/// (vim, emacs), and files or folders that appear or disappear. A file is reported when it is
/// closed or renamed into place, so never half-written.
class FileWatcher {
public:
    static Result<FileWatcher> start();
    FileWatcher(FileWatcher&& other) noexcept;
    FileWatcher& operator=(FileWatcher&& other) noexcept;
    ~FileWatcher();

    /// Watches these files, which need not exist, instead of the previous ones. Changes not yet
    /// taken are kept for files in both lists. Fails for files that the system can't watch.
    Result<void> watch(const std::vector<std::filesystem::path>& files);

    /// The files that changed since the last call, each once, with the names given to watch().
    /// Never waits.
    std::vector<std::filesystem::path> take_changed();

    /// Becomes readable (poll, epoll) when take_changed() may return files.
    int descriptor() const { return m_poll.get(); }

private:
    // Identifies a file's content, to detect a change without an event.
    struct Stamp {
        std::int64_t seconds = 0;
        std::int64_t nanoseconds = 0;
        std::int64_t size = 0;
        std::uint64_t number = 0;
        bool operator==(const Stamp&) const = default;
    };
    using Folder = std::multimap<std::string, std::filesystem::path>;  // name in the folder ->
                                                                       // watched file
    using Folders = std::map<int, Folder>;                             // by inotify watch number

    FileWatcher(Descriptor events, Descriptor timer, Descriptor poll);

    static std::optional<Stamp> stamp_of(const std::filesystem::path& file);
    Diagnostics add_watches();
    bool add_watch(const std::filesystem::path& path, const std::filesystem::path& file,
                   Folders& folders) const;
    void read_events();
    void handle_event(int folder, std::uint32_t mask, const char* name);
    void handle_file_event(const std::filesystem::path& file, std::uint32_t mask);
    void expect_back(const std::filesystem::path& file);
    void note_differences();
    void resolve_missing();

    Descriptor m_events;  // inotify
    Descriptor m_timer;   // ends the wait for a missing file
    Descriptor m_poll;    // polls both
    std::map<std::filesystem::path, std::optional<Stamp>> m_files;  // nullopt: missing
    Folders m_folders;
    std::set<std::filesystem::path> m_changed;
    std::set<std::filesystem::path> m_missing;  // may be replaced within moments (save by rename)
    std::chrono::steady_clock::time_point m_missing_until;
    bool m_is_placed = false;  // all of m_files are watched
    bool m_is_moved = false;   // a folder or link on the path of a file changed
};
