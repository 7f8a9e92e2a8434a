#include "lab/reload/watched_files.h"

#include <fmt/format.h>

#include <algorithm>

namespace fs = std::filesystem;

namespace {
std::string no_hot_reload(const Diagnostics& reasons) {
    return fmt::format("Hot reload is off: {}", to_string(reasons.front()));
}
}  // namespace

WatchedFiles::WatchedFiles() {
    if (auto watcher = FileWatcher::start())
        m_watcher = std::make_unique<FileWatcher>(std::move(*watcher));
    else
        m_problem = no_hot_reload(watcher.error());
}

void WatchedFiles::watch_look(const std::vector<fs::path>& files) {
    if (m_is_watching && files == m_look_files)
        return;
    m_look_files = files;
    watch_all();
}

void WatchedFiles::watch_extra(std::vector<fs::path> files) {
    if (files == m_extra_files)
        return;
    m_extra_files = std::move(files);
    watch_all();
}

void WatchedFiles::add_extra(const fs::path& file) {
    if (std::ranges::find(m_extra_files, file) != m_extra_files.end())
        return;
    m_extra_files.push_back(file);
    watch_all();
}

void WatchedFiles::watch_all() {
    std::vector<fs::path> all = m_look_files;
    all.insert(all.end(), m_extra_files.begin(), m_extra_files.end());
    if (!m_watcher)
        return;
    const auto watched = m_watcher->watch(all);
    m_is_watching = watched.has_value();
    if (!watched)
        m_problem = no_hot_reload(watched.error());
}

WatchedFiles::Changes WatchedFiles::take_changes() {
    Changes changes;
    if (!m_watcher)
        return changes;
    for (const fs::path& file : m_watcher->take_changed()) {
        if (std::ranges::find(m_look_files, file) != m_look_files.end())
            changes.look_file = file;
        if (std::ranges::find(m_extra_files, file) != m_extra_files.end())
            changes.extra.push_back(file);
    }
    return changes;
}
