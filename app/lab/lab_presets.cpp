// The part of Lab that goes from one preset to the next, at once or over some time.
#include "formats/preset/modulation_format.h"
#include "formats/preset/preset_format.h"
#include "formats/slang/slang_format.h"
#include "formats/slang/write.h"
#include "io/files/atomic_file.h"
#include "lab/document/morphing.h"
#include "lab/lab.h"
#include "lab/library/shelf.h"
#include "lab/storage/told_name.h"

#include <fmt/format.h>

#include <algorithm>

namespace fs = std::filesystem;

bool Lab::can_save_slang_preset() const {
    return m_document && m_document->look().stack.size() <= 1 &&
           is_slang_file(m_document->look().manifest);
}

void Lab::save_slang_preset(const fs::path& given) {
    if (!can_save_slang_preset())
        return m_messages.say("Only RetroArch looks can be saved as .slangp", true);
    const fs::path file =
        given.extension() == ".slangp" ? given : fs::path(given.string() + ".slangp");
    const Look& look = m_document->look();
    std::error_code error;
    if (fs::equivalent(file, look.manifest, error))
        return m_messages.say("A .slangp file can't reference itself. Choose another name.", true);
    const auto is_read = [&](const fs::path& read) { return fs::equivalent(file, read, error); };
    if (std::ranges::any_of(m_loader.files().look_files(), is_read))
        return m_messages.say("The open look uses this file. Choose another name.", true);
    std::map<std::string, double> values;
    std::string left_out;
    for (const Parameter& parameter : look.parameters)
        if (m_document->is_changed(parameter) && parameter.is_constant)
            left_out += (left_out.empty() ? "" : ", ") + parameter.label;
        else if (m_document->is_changed(parameter))
            values[parameter.name] = m_document->value(parameter).number();
    if (!m_messages.succeeded(
            write_atomically(file, simple_slang_preset(look.manifest, values, file))))
        return;
    const std::string name = file.filename().string();
    m_messages.say(left_out.empty() ? saved_words(name)
                                    : fmt::format("Saved \"{}\". A .slangp file can't store {}.",
                                                  name, left_out));
}

namespace {
std::vector<PresetEntry> in_listed_order(std::vector<PresetEntry> presets) {
    std::map<fs::path, std::string> names;
    for (const PresetEntry& entry : presets) {
        const auto preset = load_preset(entry.file);
        names[entry.file] = preset && !preset->name.empty() ? preset->name : entry.name;
    }
    std::ranges::sort(presets, [&names](const PresetEntry& one, const PresetEntry& other) {
        return is_listed_before(one, names[one.file], other, names[other.file]);
    });
    return presets;
}
}  // namespace

// Pressed again before the last one is read, or while a morph is under way, a key goes on from
// there.
std::optional<PresetPlace> Lab::preset_on_ring(int by, bool only_starred) {
    const std::vector<PresetEntry> presets =
        in_listed_order(m_library.presets(m_document->look().id));
    const bool is_stepping = m_preset_step && m_loader.is_reading();
    const fs::path present = is_stepping  ? m_preset_step->file
                             : m_morphing ? m_morphing->file()
                                          : m_document->preset_file();
    if (presets.empty()) {
        m_messages.say("This look has no presets yet");
        return std::nullopt;
    }
    if (!only_starred)
        return preset_beside(presets, present, by);
    auto starred = starred_beside(presets, m_presets.stars(), present, by);
    if (!starred)
        m_messages.say("This look has no favourite presets");
    return starred;
}

void Lab::step_preset(int by, bool only_starred) {
    const auto next = m_document ? preset_on_ring(by, only_starred) : std::nullopt;
    if (!next)
        return;
    open(next->file.empty() ? argument_of(m_document->look()) : next->file.string());
    m_preset_step = next;
}

void Lab::tell_preset(bool had_changes) {
    constexpr const char* restore_hint = "Press Ctrl+Z to restore your unsaved changes";
    std::string words;
    if (const auto step = std::exchange(m_preset_step, {}))
        words = step->number == 0 ? "Default"
                                  : fmt::format("{} · preset {} of {}", m_document->preset_name(),
                                                step->number, step->count);
    if (had_changes)
        words = words.empty() ? restore_hint : fmt::format("{} · {}", words, restore_hint);
    if (!words.empty())
        m_messages.say(std::move(words));
}

void Lab::morph_to(const fs::path& file, double seconds) {
    if (!m_document)
        return;
    const Look& look = m_document->look();
    Preset to;
    to.name = look.name;
    if (!file.empty()) {
        const auto preset = load_preset(file);
        if (!m_messages.succeeded(preset))
            return;
        if (preset->look != look.id)
            return m_messages.say(
                fmt::format("\"{}\" belongs to another look. It can be opened, but not morphed to.",
                            preset->name));
        to = with_checked_media(*preset, look, media_folder(file), m_drive.recent()).preset;
        const auto values = fitted_values(look, to, file);
        const auto modulations = fitted_modulations(look, *preset, file);
        if (!m_messages.succeeded(values) || !m_messages.succeeded(modulations))
            return;
        to.values = *values;
        to.modulations = *modulations;
    }
    end_morph();
    m_morphing = std::make_unique<Morphing>(*m_document, std::move(to), file, seconds);
}

void Lab::morph_by(int by, double seconds, bool only_starred) {
    if (const auto next = m_document ? preset_on_ring(by, only_starred) : std::nullopt)
        morph_to(next->file, seconds);
}

void Lab::end_morph() {
    if (m_morphing && m_document)
        m_document->finish();
    m_morphing.reset();
}

void Lab::go_on_morphing(double wall_seconds) {
    if (!m_morphing || m_morphing->go_on(*m_document, wall_seconds))
        return;
    if (m_morphing->has_arrived()) {
        watch_extra_files();
        m_messages.say(fmt::format("Morphed to \"{}\"", m_morphing->name()));
        const fs::path& file = m_morphing->file();
        if (const auto preset = load_preset(file))
            offer_content(with_checked_media(*preset, m_document->look(), media_folder(file),
                                             m_drive.recent()));
    } else {
        m_messages.say("Morph stopped because you changed something else");
    }
    m_morphing.reset();  // what was turned goes on as a step of its own
}
