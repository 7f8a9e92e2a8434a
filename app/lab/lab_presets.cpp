// The part of Lab that goes from one preset to the next.
#include "lab/lab.h"
#include "lab/preset_ring.h"

#include <fmt/format.h>

namespace fs = std::filesystem;

void Lab::step_preset(int by) {
    if (!m_document)
        return;
    const Look& look = m_document->look();
    const std::vector<PresetEntry> presets = m_library.presets(look.id);
    if (presets.empty())
        return say("This look has no presets yet");
    // Pressed again before the last one is read, the key goes on from that.
    const bool is_stepping = m_preset_step && is_loading();
    const fs::path present = is_stepping ? m_preset_step->file : m_document->preset_file();
    const PresetPlace next = preset_beside(presets, present, by);
    const std::string as_it_is =
        look.stack.size() > 1 ? look.id : look.manifest.parent_path().string();
    open(next.file.empty() ? as_it_is : next.file.string());
    m_preset_step = PresetStep{next.file, next.number, presets.size()};
}

void Lab::tell_preset(bool had_changes) {
    std::string words;
    if (const auto step = std::exchange(m_preset_step, {}))
        words = step->number == 0 ? "As the look has it"
                                  : fmt::format("{} · preset {} of {}", m_document->preset_name(),
                                                step->number, step->count);
    if (had_changes)
        words +=
            fmt::format("{}What was not saved comes back with Ctrl+Z", words.empty() ? "" : " · ");
    if (!words.empty())
        say(std::move(words));
}
