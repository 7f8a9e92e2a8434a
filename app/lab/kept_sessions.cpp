#include "lab/kept_sessions.h"

#include "base/file.h"
#include "io/atomic_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace fs = std::filesystem;

namespace {
constexpr std::size_t most_kept_sessions = 12;
constexpr std::size_t number_digits = 6;  // before the title
constexpr std::string_view json_ending = ".json";

bool is_kept_session(const fs::path& file) {
    const std::string name = file.filename().string();
    return name.size() > number_digits + json_ending.size() && name.ends_with(json_ending) &&
           std::all_of(name.begin(), name.begin() + number_digits,
                       [](unsigned char letter) { return std::isdigit(letter) != 0; });
}

// A file's name: without folders in it, and short enough.
std::string name_for(const Session& session) {
    constexpr std::size_t longest = 120;
    std::string title = session.current.preset.look;
    if (!session.saved.preset.name.empty())
        title += " – " + session.saved.preset.name;
    for (char& letter : title)
        if (letter == '/' || static_cast<unsigned char>(letter) < ' ')
            letter = '-';
    if (title.size() <= longest)
        return title;
    std::size_t end = longest;
    while (end > 0 && (static_cast<unsigned char>(title[end]) & 0xC0U) == 0x80U)
        --end;  // within a letter
    return title.substr(0, end);
}

bool holds_the_same(const Session& a, const Session& b) {
    return a.look == b.look && a.preset_file == b.preset_file && a.current == b.current;
}
}  // namespace

KeptSessions::KeptSessions(const Roots& roots) : m_folder(roots.state / "unsaved") {
    look_again();
}

void KeptSessions::look_again() {
    m_files.clear();
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(m_folder, error))
        if (is_kept_session(entry.path()))
            m_files.push_back(entry.path());
    std::ranges::sort(m_files, std::greater());
}

Result<bool> KeptSessions::keep(const Session& session) {
    if (!has_unsaved(session))
        return false;
    int number = 1;
    if (!m_files.empty()) {
        const fs::path& latest = m_files.front();
        if (const auto kept = read(latest); kept && holds_the_same(*kept, session))
            return true;
        number = std::stoi(latest.filename().string().substr(0, number_digits)) + 1;
    }
    const fs::path file = m_folder / fmt::format("{:06} {}.json", number, name_for(session));
    if (auto written = write_atomically(file, session_to_json(session)); !written)
        return fail(written.error());
    m_files.insert(m_files.begin(), file);
    while (m_files.size() > most_kept_sessions)
        forget(m_files.back());
    return true;
}

Result<Session> KeptSessions::read(const fs::path& file) {
    const auto text = read_text(file);
    return text ? parse_session(*text, file) : fail(text.error());
}

void KeptSessions::forget(const fs::path& file) {
    std::error_code error;
    fs::remove(file, error);
    std::erase(m_files, fs::path(file));
}

bool has_unsaved(const Session& session) {
    return session.current.preset.values != session.saved.preset.values ||
           session.current.preset.modulations != session.saved.preset.modulations ||
           session.current.preset.signal != session.saved.preset.signal ||
           session.current.preset.source != session.saved.preset.source ||
           session.current.overrides != session.saved.overrides;
}

std::string title_of_kept(const fs::path& file) {
    const std::string name = file.stem().string();
    return name.size() > number_digits + 1 ? name.substr(number_digits + 1) : name;
}
