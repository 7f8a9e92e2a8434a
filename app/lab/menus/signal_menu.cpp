#include "lab/menus/signal_menu.h"

#include "base/text.h"
#include "lab/document/content_edits.h"
#include "lab/document/parameter_edits.h"
#include "lab/document/users_content.h"
#include "lab/drawing/drawing_tool.h"
#include "lab/menus/scope_graticule.h"
#include "lab/playback/player.h"
#include "lab/window/window_state.h"
#include "signals/signal_table.h"

#include <fmt/format.h>

#include <cctype>

namespace {
Edit set_signal_setting(const std::string& key, Spec::Setting value) {
    return [key, value = std::move(value)](Document& document) {
        auto spec = completed(document.state().signal);
        if (!spec)
            return;
        spec->settings[key] = value;
        set_signal(document, std::move(*spec));
    };
}

// Labels alone are not unique: each channel has a frequency.
std::string full_label(const SettingInfo& setting) {
    return setting.group.empty() ? setting.label
                                 : fmt::format("{} · {}", setting.group, setting.label);
}

void add_words(const SettingInfo& setting, const Spec& spec, std::vector<MenuEntry>& entries) {
    for (const std::string& word : setting.words)
        entries.push_back({.name = fmt::format("{}: {}", full_label(setting), label_of_word(word)),
                           .commands = {set_signal_setting(setting.key, word)},
                           .is_present = spec.settings.at(setting.key) == Spec::Setting(word)});
}

MenuEntry number_setting(const SettingInfo& setting, const Spec& spec) {
    return {
        .name = fmt::format("{}…", full_label(setting)),
        .number = NumberPrompt{.current = std::get<double>(spec.settings.at(setting.key)),
                               .unit = setting.unit,
                               .limit = setting.limit,
                               .is_whole = setting.step == 1.0,
                               .help = setting.help,
                               .answer = [key = setting.key](double number) -> std::vector<Edit> {
                                   return {set_signal_setting(key, number)};
                               }}};
}

MenuEntry text_setting(const SettingInfo& setting, const SignalKind& kind, const Spec& spec) {
    const std::string name = fmt::format("{}…", full_label(setting));
    if (setting.key == kind.file_setting)
        return {.name = name, .commands = {command_for(kind)}};
    return {.name = name,
            .text = TextPrompt{std::get<std::string>(spec.settings.at(setting.key)),
                               [key = setting.key](const std::string& text) -> std::vector<Edit> {
                                   return {set_signal_setting(key, text)};
                               }}};
}

// A drawing starts immediately, although it can also have a file.
std::string name_of_kind(const SignalKind& kind) {
    const bool asks = !kind.file_setting.empty() && kind.kind != "drawing";
    return asks ? fmt::format("{}…", kind.label) : kind.label;
}

MenuSection kind_section(const std::string& current) {
    MenuSection section{"Signal", MenuSection::Menu::edit};
    for (const SignalKind& kind : signal_kinds())
        section.entries.push_back({.name = name_of_kind(kind),
                                   .commands = {command_for(kind)},
                                   .is_present = kind.kind == current});
    return section;
}

MenuSection setting_section(const Document& document) {
    MenuSection section{"Signal"};
    const SignalKind* kind = find_kind(document.state().signal.kind);
    const auto spec = completed(document.state().signal);
    section.entries.push_back(content_lock_entry(document));
    if (!kind || !spec)
        return section;
    for (const SettingInfo& setting : kind->settings) {
        if (setting.is_hidden || !is_used(setting, *spec))
            continue;
        if (setting.type == SettingType::word)
            add_words(setting, *spec, section.entries);
        else if (setting.type == SettingType::number)
            section.entries.push_back(number_setting(setting, *spec));
        else
            section.entries.push_back(text_setting(setting, *kind, *spec));
    }
    const Values graticule =
        scope_graticule(document.look(), document.values(), document.state().signal);
    if (!graticule.empty())
        section.entries.push_back(
            {.name = "Show 10 × 8 divisions", .commands = {[graticule](Document& changed) {
                                                  set_values(changed, graticule, "Graticule");
                                              }}});
    return section;
}
}  // namespace

std::string label_of_word(std::string word) {
    if (word == "look")
        return "Look default";
    if (word.size() != 2 || word == "on")
        return label_from_name(word);
    for (char& letter : word)
        letter = static_cast<char>(std::toupper(static_cast<unsigned char>(letter)));
    return word;
}

Edit command_for(const SignalKind& kind) {
    if (kind.kind == "drawing")
        return [](DrawingTool& drawing) { drawing.take_pen(true); };
    if (!kind.file_setting.empty())
        return [](WindowState& window) { window.dialog = {.kind = Dialog::Kind::open_file}; };
    if (kind.is_live)
        return [name = kind.kind](Player& player, Document& document) {
            (void)player.mute_input(false);  // the user asked for live input
            set_signal(document, with_round_circles(Spec{name, {}}));
        };
    return [name = kind.kind](Document& document) {
        if (auto spec = completed(with_round_circles(Spec{name, {}})))
            set_signal(document, std::move(*spec));
    };
}

MenuEntry content_lock_entry(const Document& document) {
    const bool is_locked = is_content_locked(document);
    return {.name = keep_content_label(driver_of(document)),
            .commands = {[is_locked](Document& changed) { lock_content(changed, !is_locked); }},
            .is_present = is_locked};
}

std::vector<MenuEntry> driver_entries(const Document& document) {
    if (!document.look().has_other_driver)
        return {};
    const Driver driver = driver_of(document);
    const Edit use_signal = [](Document& changed) {
        set_signal(changed, changed.state().signal, false, "Use a signal");
    };
    const Edit use_picture = [](Document& changed) {
        set_source(changed, changed.state().source, false, "Use a source picture");
    };
    return {{.name = "Signal", .commands = {use_signal}, .is_present = driver == Driver::signal},
            {.name = "Source picture",
             .commands = {use_picture},
             .is_present = driver == Driver::picture}};
}

std::vector<MenuSection> signal_sections(const Document& document) {
    std::vector<MenuSection> sections;
    if (auto drivers = driver_entries(document); !drivers.empty())
        sections.push_back({"Driven by", MenuSection::Menu::edit, std::move(drivers)});
    if (document.look().driven_by == Driver::signal) {
        sections.push_back(kind_section(document.state().signal.kind));
        sections.push_back(setting_section(document));
    }
    return sections;
}
