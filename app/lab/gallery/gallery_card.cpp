#include "lab/gallery/gallery_card.h"

#include "lab/document/opened_preset.h"
#include "model/look/value_text.h"
#include "model/picture/source_spec.h"
#include "signals/signal_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace fs = std::filesystem;

namespace {
// Labels of lists may look like colours, too.
std::string swatch_color(const Parameter& parameter, const std::string& text) {
    const bool is_hex = text.size() >= 7 && text.front() == '#' &&
                        std::all_of(text.begin() + 1, text.end(),
                                    [](unsigned char letter) { return std::isxdigit(letter); });
    return parameter.control == Control::color && is_hex ? text : std::string();
}

std::string with_unit(const Parameter& parameter, const std::string& text) {
    const std::string unit = unit_text(parameter);
    return text + (unit.empty() || unit == "°" ? "" : " ") + unit;
}

std::vector<GalleryValue> values_of(const Document& document) {
    std::vector<GalleryValue> values;
    const Look& look = document.look();
    const Modulations& modulations = document.state().modulations;
    for (const Parameter& parameter : look.parameters) {
        const Value& value = document.value(parameter);
        const auto modulation = modulations.find(parameter.name);
        const bool is_modulated = modulation != modulations.end();
        if (parameter.is_hidden || (value == parameter.initial && !is_modulated))
            continue;
        const std::string text = value_text(parameter, value);
        values.push_back({heading_of(look, parameter), parameter.label, with_unit(parameter, text),
                          swatch_color(parameter, text),
                          is_modulated ? summary_of(modulation->second) : std::string()});
    }
    return values;
}

bool is_initial(const SettingInfo& setting, const Spec::Setting& value) {
    return setting.type == SettingType::number ? value == Spec::Setting(setting.initial)
                                               : value == Spec::Setting(setting.initial_word);
}

// Without default settings, and without the folder of its file.
std::string signal_text(const Spec& signal) {
    const SignalKind* kind = find_kind(signal.kind);
    auto spec = completed(signal);
    if (!kind || !spec)
        return signal.kind;
    for (const SettingInfo& setting : kind->settings) {
        const auto found = spec->settings.find(setting.key);
        if (found == spec->settings.end())
            continue;
        if (is_initial(setting, found->second))
            spec->settings.erase(found);
        else if (setting.key == kind->file_setting)
            found->second = fs::path(file_of(*spec)).filename().string();
    }
    return to_string(*spec);
}

std::string source_text(const std::string& text) {
    auto source = parse_source(text);
    if (!source)
        return fs::path(text).filename().string();
    if (source->is_file())
        source->picture = fs::path(source->picture).filename().string();
    return to_string(*source);
}

std::vector<GalleryFact> facts_of(const Document& document) {
    std::vector<GalleryFact> facts;
    const Look& look = document.look();
    if (look.driven_by == Driver::signal)
        facts.push_back({"Signal", signal_text(document.state().signal)});
    if (look.driven_by == Driver::picture)
        facts.push_back({"Source", source_text(document.state().source)});
    if (uses_tempo(document.state().modulations))
        facts.push_back({"Tempo", fmt::format("{:g} BPM", document.state().tempo.bpm)});
    if (const auto bypassed = bypassed_keys(look.stack); !bypassed.empty())
        facts.push_back({"Bypassed", fmt::format("{}", fmt::join(bypassed, ", "))});
    return facts;
}
}  // namespace

GalleryCard gallery_card(const Document& document) {
    const Preset& preset = opened_preset(document).identity;
    GalleryCard card;
    card.name = preset.name;
    card.about = preset.about;
    card.author = preset.author;
    card.facts = facts_of(document);
    card.values = values_of(document);
    return card;
}
