#include "lab/commands/preset_navigation.h"

#include "formats/preset/modulation_format.h"
#include "formats/preset/preset_format.h"
#include "lab/document/opened_preset.h"
#include "lab/library/library_view.h"
#include "lab/library/named_preset.h"

#include <fmt/format.h>

#include <algorithm>

namespace fs = std::filesystem;

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

void PresetNavigation::star(const std::string& preset, bool has_star) {
    if (!m_work.document)
        return;
    const std::string star = favourite_key(m_work.document->look().id, preset);
    if (has_star)
        m_stars.insert(star);
    else
        m_stars.erase(star);
}

std::optional<PresetIndex> PresetNavigation::target(int by, bool only_starred) {
    const std::vector<PresetEntry> presets =
        in_listed_order(m_work.library.presets(m_work.document->look().id));
    const bool is_stepping = m_step && m_loader.is_opening_preset(m_step->file);
    const fs::path current = is_stepping  ? m_step->file
                             : m_morphing ? m_morphing->file()
                                          : preset_file(*m_work.document);
    if (presets.empty()) {
        m_work.messages.say("This look has no presets yet");
        return std::nullopt;
    }
    if (!only_starred)
        return preset_after(presets, current, by);
    auto starred = favourite_after(presets, m_stars, current, by);
    if (!starred)
        m_work.messages.say("This look has no favourite presets. Click the star of a preset.");
    return starred;
}

void PresetNavigation::step(int by, bool only_starred) {
    const auto next = m_work.document ? target(by, only_starred) : std::nullopt;
    if (!next)
        return;
    const std::string argument =
        next->file.empty() ? argument_of(m_work.document->look()) : next->file.string();
    const auto request = resolve(argument, m_work.library);
    if (!m_work.messages.succeeded(request))
        return;
    m_loader.open(*request);
    m_step = next;
    m_steps_favourites = only_starred;
}

Result<void> PresetNavigation::open_named(const std::string& name, std::optional<double> seconds) {
    if (!m_work.document)
        return fail(Diagnostic{{}, 0, "no look is open"});
    const Look& look = m_work.document->look();
    const auto file = find_named_preset(m_work.library, look.id, name);
    if (!file)
        return fail(file.error());
    const auto request =
        resolve(file->empty() ? argument_of(look) : file->string(), m_work.library);
    if (!request)
        return fail(request.error());
    if (seconds && *seconds > 0.0 && (!request->preset || request->preset->look == look.id))
        return morph_to(*file, *seconds);
    m_loader.open(*request);
    return {};
}

std::vector<std::string> PresetNavigation::names() const {
    std::vector<std::string> names;
    if (m_work.document)
        for (const PresetEntry& entry :
             in_listed_order(m_work.library.presets(m_work.document->look().id)))
            names.push_back(entry.id);
    return names;
}

void PresetNavigation::note_opened(const OpenRequest& request, bool had_changes) {
    constexpr const char* restore_hint = "Press Ctrl+Z to restore your unsaved changes";
    std::string text;
    m_morphing.reset();
    if (const auto step = std::exchange(m_step, {}); step && step->file == request.preset_file)
        text = step->number == 0 ? "Default"
                                 : fmt::format("{} · {} {} of {}", preset_name(*m_work.document),
                                               m_steps_favourites ? "favourite" : "preset",
                                               step->number, step->count);
    if (had_changes)
        text = text.empty() ? restore_hint : fmt::format("{} · {}", text, restore_hint);
    if (!text.empty())
        m_work.messages.say(std::move(text));
}

Result<void> PresetNavigation::morph_to(const fs::path& file, double seconds) {
    if (!m_work.document)
        return fail(Diagnostic{{}, 0, "no look is open"});
    const Look& look = m_work.document->look();
    Preset to;
    to.name = look.name;
    if (!file.empty()) {
        const auto preset = load_preset(file);
        if (!preset)
            return fail(preset.error());
        if (preset->look != look.id)
            return fail({{},
                         0,
                         fmt::format("\"{}\" belongs to another look. It can be opened, but not "
                                     "morphed to.",
                                     preset->name)});
        to = with_checked_media(*preset, look, media_folder(file), m_work.media.recent()).preset;
        const auto values = fitted_values(look, to, file);
        if (!values)
            return fail(values.error());
        const auto modulations = fitted_modulations(look, *preset, file);
        if (!modulations)
            return fail(modulations.error());
        to.values = *values;
        to.modulations = *modulations;
    }
    end_morph();
    m_morphing = std::make_unique<Morphing>(*m_work.document, std::move(to), file, seconds);
    return {};
}

void PresetNavigation::morph_by(int by, double seconds, bool only_starred) {
    if (const auto next = m_work.document ? target(by, only_starred) : std::nullopt)
        morph_to(next->file, seconds);
}

void PresetNavigation::end_morph() {
    if (m_morphing && m_work.document)
        m_work.document->finish();
    m_morphing.reset();
}

void PresetNavigation::update(double wall_seconds) {
    if (!m_morphing || m_morphing->update(*m_work.document, wall_seconds))
        return;
    if (m_morphing->is_finished()) {
        m_work.messages.say(fmt::format("Morphed to \"{}\"", m_morphing->name()));
        const fs::path& file = m_morphing->file();
        if (const auto preset = load_preset(file))
            m_content.offer(with_checked_media(*preset, m_work.document->look(), media_folder(file),
                                               m_work.media.recent()));
    } else {
        m_work.messages.say("Morph stopped because you changed something else");
    }
    m_morphing.reset();  // the change stays, as its own undo step
}
