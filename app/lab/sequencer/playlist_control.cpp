#include "lab/sequencer/playlist_control.h"

#include "base/file.h"
#include "formats/settings/playlist_format.h"
#include "io/files/atomic_file.h"
#include "lab/document/opened_preset.h"
#include "lab/document/parameter_edits.h"
#include "lab/library/named_preset.h"
#include "lab/library/open.h"
#include "lab/sequencer/sequencer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace fs = std::filesystem;

// A stack's '+' is valid in file names; its looks have plain names.
fs::path PlaylistControl::file() const {
    return m_work.library.roots().user / "playlists" / (m_look + ".json");
}

// A file with errors leaves the list as it is.
void PlaylistControl::read() {
    m_is_broken = false;
    std::error_code error;
    if (m_look.empty() || !fs::exists(file(), error))
        return;
    const auto text = read_text(file());
    const auto list = text ? parse_playlist(*text, file()) : fail(text.error());
    m_is_broken = !m_work.messages.succeeded(list);
    if (list)
        m_list = *list;
    m_is_playing &= !m_list.presets.empty();
}

void PlaylistControl::file_changed(const fs::path& changed) {
    if (!m_look.empty() && changed == file())
        read();
}

void PlaylistControl::set_list(Playlist list) {
    if (m_look.empty() || list == m_list)
        return;
    if (list.presets.size() > max_playlist_presets)
        return m_work.messages.say(
            fmt::format("A playlist can have at most {} presets. Remove some first.",
                        max_playlist_presets),
            true);
    m_list = std::move(list);
    if (m_list.presets.empty())
        m_is_playing = false;
    if (m_is_broken)
        return m_work.messages.say(
            {file(), 0, "can't save the playlist: the file has errors. Correct or delete it."});
    std::error_code error;
    fs::create_directories(file().parent_path(), error);  // a failure is reported below
    m_work.messages.succeeded(write_atomically(file(), playlist_to_json(m_list)));
}

void PlaylistControl::add_open_preset() {
    if (!m_work.document || preset_file(*m_work.document).empty())
        return;
    Playlist next = m_list;
    next.presets.push_back(reference_to_preset(
        m_work.library, m_look, preset_file(*m_work.document), preset_name(*m_work.document)));
    set_list(std::move(next));
}

void PlaylistControl::add_all() {
    Playlist next = m_list;
    const std::vector<std::string> names = m_navigation.names();
    next.presets.insert(next.presets.end(), names.begin(), names.end());
    set_list(std::move(next));
}

void PlaylistControl::clear() {
    Playlist next = m_list;
    next.presets.clear();
    const Playlist before = m_list;
    set_list(std::move(next));
    m_work.messages.offer("Cleared the playlist",
                          {.name = "Undo", .commands = {[before](Sequencer& sequencer) {
                                               sequencer.playlist().set_list(before);
                                           }}});
}

std::size_t PlaylistControl::index() const {
    return m_list.presets.empty()
               ? 0
               : playlist_index(m_step, m_list.presets.size(), m_list.is_shuffled, m_seed);
}

// Morphs to the current preset; false: it can't be read.
bool PlaylistControl::show() {
    const std::string& name = m_list.presets[index()];
    const auto request = resolve_preset(name, m_look, m_work.library);
    if (!request) {
        m_work.messages.say(request.error().front());
        return false;
    }
    if (request->preset_file.empty()) {
        m_work.messages.say(
            fmt::format("Playlist: this look has no preset \"{}\". Remove it from the playlist.",
                        name),
            true);
        return false;
    }
    if (!m_work.messages.succeeded(
            m_navigation.morph_to(request->preset_file, m_list.morph_seconds)))
        return false;
    m_seconds = 0.0;
    return true;
}

void PlaylistControl::set_playing(bool is_playing) {
    if (is_playing && m_list.presets.empty())
        return m_work.messages.say("The playlist is empty. Add presets to it first.");
    if (is_playing == m_is_playing)
        return;
    m_is_playing = is_playing;
    if (!is_playing)
        return;
    m_seed = random_seed();
    if (!show())
        step(1);
}

void PlaylistControl::step(int by) {
    if (m_list.presets.empty())
        return m_work.messages.say("The playlist is empty. Add presets to it first.");
    for (std::size_t tried = 0; tried < m_list.presets.size(); ++tried) {
        m_step += by;
        if (show())
            return;
    }
    m_is_playing = false;
}

void PlaylistControl::go_to(std::size_t index) {
    const auto count = static_cast<std::int64_t>(m_list.presets.size());
    for (std::int64_t by = 0; by < count; ++by)
        if (playlist_index(m_step + by, m_list.presets.size(), m_list.is_shuffled, m_seed) ==
            index) {
            m_step += by;
            static_cast<void>(show());
            return;
        }
}

// The time in units of a preset's time.
double PlaylistControl::slots(const Tempo& tempo) const {
    return m_list.unit == Playlist::Unit::bars
               ? tempo.bars_at(m_work.player.transport().time()) / m_list.every
               : m_seconds / m_list.every;
}

double PlaylistControl::share(const Tempo& tempo) const {
    const double now = slots(tempo);
    return std::clamp(now - std::floor(now), 0.0, 1.0);
}

void PlaylistControl::update(const Tempo& tempo, double wall_seconds) {
    const std::string look = m_work.document ? m_work.document->look().id : std::string();
    if (look != m_look) {
        m_look = look;
        m_list = {};
        m_step = 0;
        m_is_playing = false;
        read();
    }
    if (m_work.player.transport().is_playing())
        m_seconds += wall_seconds;
    const double slot = std::floor(slots(tempo));
    // A seek, or a change of the tempo or of the list, is not an advance.
    const bool is_due = m_list.unit == Playlist::Unit::bars ? slot == m_slot + 1.0 : slot >= 1.0;
    m_slot = slot;
    if (!m_is_playing || !is_due)
        return;
    const double rest = std::max(m_seconds - m_list.every, 0.0);
    step(1);
    if (m_list.unit == Playlist::Unit::seconds)
        m_seconds = std::min(rest, m_list.every);  // so that no time is lost
}
