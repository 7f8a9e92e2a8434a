#include "lab/storage/session_stash.h"

#include "base/file.h"
#include "io/files/atomic_file.h"
#include "io/pictures/picture_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <set>

namespace fs = std::filesystem;

namespace {
constexpr std::size_t max_stashed_sessions = 12;
constexpr std::size_t number_digits = 6;  // before the title
constexpr std::string_view json_ending = ".json";

bool is_stashed_session(const fs::path& file) {
    const std::string name = file.filename().string();
    return name.size() > number_digits + json_ending.size() && name.ends_with(json_ending) &&
           std::all_of(name.begin(), name.begin() + number_digits,
                       [](unsigned char letter) { return std::isdigit(letter) != 0; });
}

// A valid file name of limited length.
std::string name_for(const Session& session) {
    constexpr std::size_t longest = 120;
    std::string title = session.current.preset.look;
    if (const std::string& name = session.opened.front().saved.preset.name; !name.empty())
        title += " – " + name;
    for (char& letter : title)
        if (letter == '/' || static_cast<unsigned char>(letter) < ' ')
            letter = '-';
    if (title.size() <= longest)
        return title;
    std::size_t end = longest;
    while (end > 0 && (static_cast<unsigned char>(title[end]) & 0xC0U) == 0x80U)
        --end;  // within a UTF-8 character
    return title.substr(0, end);
}

fs::path picture_of(const fs::path& file) {
    return fs::path(file).replace_extension(".png");
}

// A damaged file is listed by its file name.
StashedSession described(const fs::path& file) {
    std::error_code error;
    StashedSession listed;
    listed.file = file;
    listed.picture = picture_of(file);
    listed.time = fs::last_write_time(file, error);
    listed.look =
        file.stem().string().substr(std::min(number_digits + 1, file.stem().string().size()));
    if (const auto session = SessionStash::read(file)) {
        listed.look = session->current.preset.look;
        listed.preset = session->opened.front().saved.preset.name;
        listed.changes = count_changes(*session);
    }
    return listed;
}

bool holds_the_same(const Session& a, const Session& b) {
    return a.look == b.look && a.opened.front().file == b.opened.front().file &&
           a.current == b.current;
}
}  // namespace

SessionStash::SessionStash(const Roots& roots) : m_folder(roots.state / "unsaved") {
    look_again();
}

void SessionStash::look_again() {
    m_files.clear();
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(m_folder, error))
        if (is_stashed_session(entry.path()))
            m_files.push_back(entry.path());
    std::ranges::sort(m_files, std::greater());
}

const std::vector<StashedSession>& SessionStash::list() const {
    std::vector<StashedSession> all;
    for (const fs::path& file : m_files) {
        const auto known = std::ranges::find(m_list, file, &StashedSession::file);
        if (known != m_list.end())
            all.push_back(*known);
        else
            all.push_back(described(file));
    }
    m_list = std::move(all);
    return m_list;
}

Result<bool> SessionStash::keep(const Session& session,
                                const std::function<std::optional<Picture>()>& picture) {
    if (!has_unsaved(session))
        return false;
    int number = 1;
    if (!m_files.empty()) {
        const fs::path& latest = m_files.front();
        if (const auto stored = read(latest); stored && holds_the_same(*stored, session))
            return true;
        number = std::stoi(latest.filename().string().substr(0, number_digits)) + 1;
    }
    const fs::path file = m_folder / fmt::format("{:06} {}.json", number, name_for(session));
    if (auto written = write_atomically(file, session_to_json(session)); !written)
        return fail(written.error());
    m_files.insert(m_files.begin(), file);
    if (const auto drawn = picture ? picture() : std::nullopt)
        (void)save_picture(*drawn, picture_of(file));  // optional, so errors are ignored
    while (m_files.size() > max_stashed_sessions)
        forget(m_files.back());
    return true;
}

Result<Session> SessionStash::read(const fs::path& file) {
    const auto text = read_text(file);
    return text ? parse_session(*text, file) : fail(text.error());
}

void SessionStash::forget(const fs::path& file) {
    std::error_code error;
    fs::remove(file, error);
    fs::remove(picture_of(file), error);
    std::erase(m_files, fs::path(file));
}

namespace {
// The number of keys that are missing in one map or have different values.
template <class T>
std::size_t count_differences(const std::map<std::string, T>& one,
                              const std::map<std::string, T>& other) {
    std::set<std::string> keys;
    for (const auto& [key, value] : one)
        if (const auto found = other.find(key); found == other.end() || found->second != value)
            keys.insert(key);
    for (const auto& [key, value] : other)
        if (!one.contains(key))
            keys.insert(key);
    return keys.size();
}
}  // namespace

std::size_t count_changes(const Session& session) {
    const SessionState& now = session.current;
    const SessionState& saved = session.opened.front().saved;
    const bool is_signal = !now.locks.signal && now.preset.signal != saved.preset.signal;
    const bool is_source = !now.locks.source && now.preset.source != saved.preset.source;
    return count_differences(now.preset.values, saved.preset.values) +
           count_differences(now.preset.modulations, saved.preset.modulations) +
           count_differences(now.overrides, saved.overrides) + (is_signal ? 1 : 0) +
           (is_source ? 1 : 0);
}

bool has_unsaved(const Session& session) {
    return count_changes(session) > 0;
}

std::string age_text(double seconds) {
    constexpr double minute = 60.0;
    constexpr double hour = 60.0 * minute;
    constexpr double day = 24.0 * hour;
    if (seconds < minute)
        return "just now";
    if (seconds < hour)
        return fmt::format("{:.0f} min ago", std::floor(seconds / minute));
    if (seconds < day)
        return fmt::format("{:.0f} h ago", std::floor(seconds / hour));
    const double days = std::floor(seconds / day);
    return days == 1.0 ? "1 day ago" : fmt::format("{:.0f} days ago", days);
}
