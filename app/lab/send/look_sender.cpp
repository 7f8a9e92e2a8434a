#include "lab/send/look_sender.h"

#include "lab/export/export_target.h"
#include "lab/send/running_program.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

namespace fs = std::filesystem;

namespace {
constexpr double shortest_interval = 0.25;  // s

std::string unused_stem() {
    const auto now = std::chrono::system_clock::now().time_since_epoch();
    return fmt::format("look-{}",
                       std::chrono::duration_cast<std::chrono::microseconds>(now).count());
}

// Removes all but the last exports. Their names start with the time.
void remove_old(const fs::path& folder) {
    constexpr std::size_t kept = 2;
    std::error_code ignored;
    std::vector<std::string> stems;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored))
        if (entry.is_regular_file(ignored))
            stems.push_back(entry.path().stem().string());
    std::ranges::sort(stems);
    stems.resize(stems.size() > kept ? stems.size() - kept : 0);
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored)) {
        const std::string name = entry.path().filename().string();
        if (std::ranges::any_of(stems,
                                [&](const std::string& stem) { return name.starts_with(stem); }))
            fs::remove_all(entry.path(), ignored);
    }
}
}  // namespace

Result<void> send_look(const PreparedLook& prepared, Extent size, const SendSettings& settings,
                       const fs::path& folder) {
    const RunningProgram& program = running_programs()[settings.program];
    const auto target = find_export_target(program.target);
    if (!target)
        return fail(target.error());
    const fs::path own = folder / program.target;
    std::error_code error;
    fs::create_directories(own, error);
    if (error)
        return fail({own, 0, error.message()});
    const fs::path file = own / (unused_stem() + (*target)->extension);
    if (auto made = export_look(**target, {prepared, size, file}); !made)
        return fail(made.error());
    remove_old(own);
    return program.load(file, settings.address);
}

void LookSender::send(const Document& document, const PassSwitches& switches, Extent size,
                      const SendSettings& settings) {
    m_settings = settings;
    m_age = 0.0;
    m_look = document.look();
    m_state = document.state();
    m_switches = switches;
    m_is_reported = false;
    m_work.start(
        [document, switches, size, settings, folder = m_folder](JobProgress&) -> Result<bool> {
            const auto sent = send_look(PreparedLook{.document = document, .switches = switches},
                                        size, settings, folder);
            return sent ? Result<bool>(true) : fail(sent.error());
        });
}

bool LookSender::has_changed(const Document& document, const PassSwitches& switches) const {
    return !document.has_pending_stack() &&
           (m_state != document.state() || m_switches != switches || m_look != document.look());
}

void LookSender::update(const Document* document, const PassSwitches& switches, Extent size,
                        Messages& messages, double wall_seconds) {
    m_age += wall_seconds;
    m_work.update();
    const auto& outcome = m_work.outcome();
    if (outcome && !m_is_reported) {
        m_is_reported = true;
        if (!*outcome && m_settings.follows)
            messages.say(outcome->error().front());
        m_settings.follows = m_settings.follows && outcome->has_value();
    }
    m_is_waiting = m_settings.follows && document && has_changed(*document, switches);
    if (m_is_waiting && m_work.is_free() && m_age >= shortest_interval)
        send(*document, switches, size, m_settings);
}
