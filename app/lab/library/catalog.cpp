#include "lab/library/catalog.h"

#include "base/text.h"
#include "formats/look_format.h"
#include "formats/preset/preset_format.h"
#include "glsl/cache/check_cache.h"
#include "signals/patterns/patterns.h"
#include "signals/signal_table.h"

#include <algorithm>

std::vector<CatalogEntry> list_looks(const Library& library) {
    std::vector<CatalogEntry> entries;
    CheckCache checks(nullptr, library.roots().shader_limits);
    for (const LookEntry& look : library.looks()) {
        const LoadedLook loaded =
            load_look(look.folder, library.roots().include_folders(), {&checks});
        if (loaded.look)
            entries.push_back({look.id, loaded.look->name, loaded.look->about, {}, look.folder});
        else
            entries.push_back(
                {look.id, look.id, to_string(loaded.look.error().front()), {}, look.folder});
    }
    return entries;
}

std::vector<CatalogEntry> list_presets(const Library& library) {
    std::vector<CatalogEntry> entries;
    std::vector<std::string> looks = library.stacks();
    for (const LookEntry& look : library.looks())
        looks.push_back(look.id);
    std::sort(looks.begin(), looks.end());
    for (const std::string& look : looks)
        for (const PresetEntry& entry : library.presets(look)) {
            const auto preset = load_preset(entry.file);
            if (preset)
                entries.push_back({entry.name, preset->name, preset->about, look, entry.file});
            else
                entries.push_back(
                    {entry.name, entry.name, to_string(preset.error().front()), look, entry.file});
        }
    return entries;
}

namespace {
// " v1=0.25 V/div. Volts a division..."
std::string setting_line(const SettingInfo& setting) {
    std::string shown = "  " + setting.key + '=';
    if (setting.type == SettingType::number)
        shown += format_number(setting.initial);
    else if (setting.type == SettingType::word)
        shown += setting.initial_word;
    constexpr std::size_t width = 26;
    shown.resize(std::max(shown.size() + 1, width), ' ');
    for (const std::string& word : setting.words)
        shown += word + (&word == &setting.words.back() ? ". " : "|");
    if (!setting.unit.empty())
        shown += setting.unit + ". ";
    return shown + setting.help;
}
}  // namespace

std::vector<CatalogEntry> list_signals() {
    std::vector<CatalogEntry> entries;
    for (const SignalKind& kind : signal_kinds()) {
        std::string about = kind.help;
        for (const SettingInfo& setting : kind.settings)
            about += '\n' + setting_line(setting);
        entries.push_back({kind.kind, kind.label, std::move(about), {}, {}});
    }
    return entries;
}

std::vector<CatalogEntry> list_patterns() {
    std::vector<CatalogEntry> entries;
    for (const PatternInfo& pattern : all_patterns())
        entries.push_back({pattern.name, pattern.label, pattern.help, {}, {}});
    return entries;
}
