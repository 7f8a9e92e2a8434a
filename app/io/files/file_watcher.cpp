#include "io/files/file_watcher.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <sys/epoll.h>
#include <sys/inotify.h>
#include <sys/stat.h>
#include <sys/timerfd.h>

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

namespace {
constexpr std::uint32_t gone = IN_DELETE | IN_MOVED_FROM;
constexpr std::uint32_t folder_gone = IN_IGNORED | IN_DELETE_SELF | IN_MOVE_SELF | IN_UNMOUNT;
constexpr std::uint32_t watched_events =
    IN_CLOSE_WRITE | IN_MOVED_TO | IN_CREATE | gone | IN_DELETE_SELF | IN_MOVE_SELF | IN_ONLYDIR;
// Editors that save by rename leave the name missing for some milliseconds at most.
constexpr std::chrono::milliseconds timeout{200};

bool add_to_poll(int poll, int descriptor) {
    epoll_event event = {};
    event.events = EPOLLIN;
    return ::epoll_ctl(poll, EPOLL_CTL_ADD, descriptor, &event) == 0;
}

// A link or an additional hard link: complete when created, without a close event.
bool is_complete_when_created(const fs::path& file) {
    struct stat status = {};
    return ::lstat(file.c_str(), &status) == 0 && (S_ISLNK(status.st_mode) || status.st_nlink > 1);
}

fs::path absolute_path(const fs::path& file) {
    std::error_code error;
    return fs::absolute(file, error).lexically_normal();
}
}  // namespace

FileWatcher::FileWatcher(Descriptor events, Descriptor timer, Descriptor poll)
    : m_events(std::move(events)), m_timer(std::move(timer)), m_poll(std::move(poll)) {}

FileWatcher::FileWatcher(FileWatcher&& other) noexcept = default;
FileWatcher& FileWatcher::operator=(FileWatcher&& other) noexcept = default;
FileWatcher::~FileWatcher() = default;

Result<FileWatcher> FileWatcher::start() {
    Descriptor events(::inotify_init1(IN_NONBLOCK | IN_CLOEXEC));
    Descriptor timer(::timerfd_create(CLOCK_MONOTONIC, TFD_NONBLOCK | TFD_CLOEXEC));
    Descriptor poll(::epoll_create1(EPOLL_CLOEXEC));
    if (!events.is_open() || !timer.is_open() || !poll.is_open() ||
        !add_to_poll(poll.get(), events.get()) || !add_to_poll(poll.get(), timer.get()))
        return fail(
            {{}, 0, fmt::format("can't watch files for changes: {}", std::strerror(errno))});
    return FileWatcher(std::move(events), std::move(timer), std::move(poll));
}

Result<void> FileWatcher::watch(const std::vector<fs::path>& files) {
    std::map<fs::path, std::optional<Stamp>> watched;
    for (const fs::path& file : files) {
        const auto known = m_files.find(file);
        watched[file] = known == m_files.end() ? stamp_of(file) : known->second;
    }
    const auto has_same_name = [](const auto& one, const auto& other) {
        return one.first == other.first;
    };
    const bool is_as_before = std::ranges::equal(watched, m_files, has_same_name);
    m_files = std::move(watched);
    if (is_as_before && m_is_placed)
        return {};
    Diagnostics problems = add_watches();
    m_is_placed = problems.empty();
    if (!problems.empty())
        return fail(std::move(problems));
    return {};
}

std::vector<fs::path> FileWatcher::take_changed() {
    read_events();
    if (m_is_moved) {
        m_is_moved = false;
        add_watches();
        note_differences();
    }
    resolve_missing();
    std::vector<fs::path> changed;
    for (const fs::path& file : m_changed) {
        const auto watched = m_files.find(file);
        if (watched == m_files.end())
            continue;
        watched->second = stamp_of(file);
        changed.push_back(file);
    }
    m_changed.clear();
    return changed;
}

std::optional<FileWatcher::Stamp> FileWatcher::stamp_of(const fs::path& file) {
    struct stat status = {};
    if (::stat(file.c_str(), &status) != 0)
        return std::nullopt;
    return Stamp{status.st_mtim.tv_sec, status.st_mtim.tv_nsec, status.st_size, status.st_ino};
}

Diagnostics FileWatcher::add_watches() {
    Diagnostics problems;
    Folders folders;
    for (const auto& [file, stamp] : m_files) {
        const fs::path path = absolute_path(file);
        std::error_code error;
        const fs::path target = fs::weakly_canonical(path, error);
        const bool is_watched =
            add_watch(path, file, folders) &&
            (target.empty() || target == path || add_watch(target, file, folders));
        if (!is_watched)
            problems.push_back(
                {file, 0,
                 fmt::format("can't watch this file for changes: {}", std::strerror(errno))});
    }
    for (const auto& [number, folder] : m_folders)
        if (!folders.contains(number))
            ::inotify_rm_watch(m_events.get(), number);
    m_folders = std::move(folders);
    return problems;
}

bool FileWatcher::add_watch(const fs::path& path, const fs::path& file, Folders& folders) const {
    // A watch on the nearest existing folder reports when the next folder of the path appears.
    for (fs::path next = path; next.has_relative_path(); next = next.parent_path()) {
        const int number =
            ::inotify_add_watch(m_events.get(), next.parent_path().c_str(), watched_events);
        if (number < 0 && errno != ENOENT && errno != ENOTDIR)
            return false;
        if (number < 0)
            continue;
        folders[number].emplace(next.filename().string(), file);
        std::error_code error;
        const bool appeared_meanwhile = next != path && fs::is_directory(next, error);
        return !appeared_meanwhile || add_watch(path, file, folders);
    }
    return true;
}

void FileWatcher::read_events() {
    alignas(inotify_event) std::array<char, 16384> buffer;
    for (;;) {
        const ssize_t size = ::read(m_events.get(), buffer.data(), buffer.size());
        if (size <= 0)
            return;
        for (std::size_t at = 0; at < static_cast<std::size_t>(size);) {
            inotify_event event = {};
            std::memcpy(&event, buffer.data() + at, sizeof event);
            handle_event(event.wd, event.mask,
                         event.len > 0 ? buffer.data() + at + sizeof event : "");
            at += sizeof event + event.len;
        }
    }
}

void FileWatcher::handle_event(int folder, std::uint32_t mask, const char* name) {
    if (mask & IN_Q_OVERFLOW) {
        for (const auto& [file, stamp] : m_files)
            m_changed.insert(file);
        m_is_moved = true;
        return;
    }
    const auto watched = m_folders.find(folder);
    if (watched == m_folders.end())
        return;
    if (mask & folder_gone) {
        m_is_moved = true;
        return;
    }
    const auto [first, last] = watched->second.equal_range(name);
    for (auto file = first; file != last; ++file) {
        if (mask & IN_ISDIR)
            m_is_moved = true;
        else
            handle_file_event(file->second, mask);
    }
}

void FileWatcher::handle_file_event(const fs::path& file, std::uint32_t mask) {
    const bool is_link_or_name = is_complete_when_created(file);
    m_is_moved = m_is_moved || is_link_or_name;
    if (mask & gone) {
        expect_back(file);
    } else if (!(mask & IN_CREATE) || is_link_or_name) {
        m_missing.erase(file);
        m_changed.insert(file);
    }
}

void FileWatcher::expect_back(const fs::path& file) {
    m_missing.insert(file);
    m_missing_until = Clock::now() + timeout;
    itimerspec once = {};
    once.it_value.tv_nsec = std::chrono::nanoseconds(timeout).count();
    ::timerfd_settime(m_timer.get(), 0, &once, nullptr);
}

void FileWatcher::note_differences() {
    for (const auto& [file, stamp] : m_files) {
        const std::optional<Stamp> now = stamp_of(file);
        if (now && now != stamp)
            m_changed.insert(file);
        else if (!now && stamp)
            expect_back(file);
    }
}

void FileWatcher::resolve_missing() {
    std::uint64_t expirations = 0;
    const bool is_over = ::read(m_timer.get(), &expirations, sizeof expirations) > 0 ||
                         Clock::now() >= m_missing_until;
    std::set<fs::path> waiting;
    for (const fs::path& file : m_missing) {
        if (stamp_of(file))
            continue;  // it exists again, and is reported when it is closed
        (is_over ? m_changed : waiting).insert(file);
    }
    m_missing = std::move(waiting);
}
