// Entries of menus and the command palette, without a window.
#include "lab/document/content_edits.h"
#include "lab/menus/device_menu.h"
#include "lab/menus/inspector_menu.h"
#include "lab/menus/palette.h"
#include "lab/menus/parameter_menu.h"
#include "lab/menus/preset_menu.h"
#include "lab/menus/signal_menu.h"
#include "lab/menus/source_menu.h"
#include "lab/menus/stack_menu.h"
#include "lab/menus/window_menu.h"
#include "lab/window/pane_sizes.h"
#include "model/picture/source_spec.h"
#include "signals/patterns/patterns.h"
#include "signals/signal_table.h"

#include <doctest/doctest.h>

#include <algorithm>

namespace {
Look menu_look(Driver driver) {
    Look look;
    look.id = "phosphor";
    look.name = "Phosphor";
    look.driven_by = driver;
    look.default_signal = Spec{"lissajous", {}};
    look.default_source = "pattern:bars";
    look.stack = {{"phosphor", "/looks/phosphor", "phosphor"}};
    Parameter tint;
    tint.name = "tint";
    tint.label = "Tint";
    tint.group = "Glass";
    tint.type = {Scalar::floating, 3};
    tint.initial = Value(std::vector<double>{1.0, 1.0, 1.0});
    look.parameters = {tint};
    look.passes.resize(1);
    look.passes[0].name = "beam";
    return look;
}

ListedLook listed_look(const char* id, const char* name) {
    ListedLook look;
    look.entry = {id, std::string("/looks/") + id, false};
    look.name = name;
    return look;
}

const MenuEntry* find_menu_entry(const std::vector<MenuSection>& sections,
                                 const std::string& label) {
    for (const MenuSection& section : sections)
        for (const MenuEntry& entry : section.entries)
            if (section.label_of(entry) == label)
                return &entry;
    return nullptr;
}

const MenuEntry& menu_entry_of(const std::vector<MenuSection>& sections, const std::string& label) {
    const MenuEntry* found = find_menu_entry(sections, label);
    REQUIRE_MESSAGE(found, label);
    return *found;
}

template <class Subject>
void take(const std::vector<Edit>& commands, Subject& subject) {
    MutableParts parts;
    std::get<Subject*>(parts) = &subject;
    for (const Edit& command : commands)
        command(parts);
}

std::string first_found(const std::vector<PaletteEntry>& entries, const char* query) {
    const auto matches = find_entries(entries, query, {});
    return matches.empty() ? "" : entries[matches.front().entry].label;
}
}  // namespace

TEST_CASE("every kind of signal can be chosen by name in one undo step") {
    Document document(menu_look(Driver::signal));
    const auto sections = signal_sections(document);
    CHECK(sections.front().entries.size() == signal_kinds().size());
    for (const SignalKind& kind : signal_kinds()) {
        const std::string name =
            kind.label + (kind.kind == "audio" || kind.kind == "scene" ? "…" : "");
        CHECK(menu_entry_of(sections, "Signal: " + name).is_present == (kind.kind == "lissajous"));
    }
    take(menu_entry_of(sections, "Signal: " + find_kind("waveform")->label).commands, document);
    CHECK(document.state().signal.kind == "waveform");
    CHECK(document.history().undo_name() == "Signal");
    document.undo();
    CHECK(document.state().signal.kind == "lissajous");
    WindowState window;
    take(menu_entry_of(sections, "Signal: " + find_kind("audio")->label + "…").commands, window);
    CHECK(window.dialog.kind == Dialog::Kind::open_file);
    CHECK(signal_sections(Document(menu_look(Driver::picture))).empty());
}

TEST_CASE("every used setting of the current signal can be typed or chosen") {
    Document document(menu_look(Driver::signal));
    set_signal(document, *completed(Spec{"waveform", {}}));
    const SignalKind& kind = *find_kind("waveform");
    const Spec spec = *completed(document.state().signal);
    const auto sections = signal_sections(document);
    for (const SettingInfo& setting : kind.settings) {
        if (setting.is_hidden || !is_used(setting, spec))
            continue;
        const std::string name =
            setting.group.empty() ? setting.label : setting.group + " · " + setting.label;
        if (setting.type != SettingType::word) {
            CHECK_MESSAGE(find_menu_entry(sections, "Signal: " + name + "…"), setting.key);
            continue;
        }
        for (const std::string& word : setting.words)
            CHECK_MESSAGE(find_menu_entry(sections, "Signal: " + name + ": " + label_of_word(word)),
                          word);
    }
    const auto number = std::ranges::find_if(kind.settings, [&](const SettingInfo& setting) {
        return setting.type == SettingType::number && !setting.is_hidden && is_used(setting, spec);
    });
    REQUIRE(number != kind.settings.end());
    const MenuEntry& entry =
        menu_entry_of(sections, "Signal: " + number->group + " · " + number->label + "…");
    REQUIRE(entry.number);
    CHECK(find_menu_entry(sections, "Signal: Wave 2 · Frequency…"));  // each wave has its own entry
    CHECK(entry.number->limit == number->limit);
    const double typed = entry.number->current + 1.0;
    take(entry.number->answer(typed), document);
    const auto changed = completed(document.state().signal);
    CHECK(std::get<double>(changed->settings.at(number->key)) == typed);
}

TEST_CASE("pattern, size, fit and pixel aspect of a source can be chosen by name") {
    Document document(menu_look(Driver::picture));
    const PatternInfo& last = all_patterns().back();
    take(menu_entry_of(source_sections(document, {}), "Source: " + last.label).commands, document);
    CHECK(document.state().source == "pattern:" + last.name);
    take(menu_entry_of(source_sections(document, {}), "Source: Size: 256 × 224").commands,
         document);
    CHECK(document.state().source == "pattern:" + last.name + ",size=256x224");
    CHECK(menu_entry_of(source_sections(document, {}), "Source: Size: 256 × 224").is_present);
    CHECK(menu_entry_of(source_sections(document, {}), "Source: " + last.label).is_present);
    take(menu_entry_of(source_sections(document, {}), "Source: Size: Native size").commands,
         document);
    CHECK(document.state().source == "pattern:" + last.name);
    take(menu_entry_of(source_sections(document, {}), "Source: Scaling: Fit").commands, document);
    CHECK_FALSE(find_menu_entry(source_sections(document, {}), "Source: Pre-scaled: Auto"));
    const auto sections = source_sections(document, {});
    CHECK(menu_entry_of(sections, "Source: Scaling: Fit").is_present);
    take(menu_entry_of(sections, "Source: Pixel aspect…").number->answer(1.5), document);
    CHECK(document.state().source == "pattern:" + last.name + ",fit=whole,aspect=1.5");
    CHECK_FALSE(find_menu_entry(sections, "Source: Frame rate…"));
    const auto film = source_sections(document, {.film_rate = 25.0});
    CHECK(menu_entry_of(film, "Source: Frame rate…").number->current == 25.0);
    take(menu_entry_of(film, "Source: At end: Hold").commands, document);
    CHECK_FALSE(parse_source(document.state().source)->loops);
}

TEST_CASE("shape and prescale of a file can be chosen by name") {
    Document document(menu_look(Driver::picture));
    set_source(document, "game.png,fit=whole,prescaled=auto");
    const auto sections = [&document] {
        return source_sections(document, {.extent = {256, 224}, .prescale = 3});
    };
    CHECK(menu_entry_of(sections(), "Source: Pre-scaled: Auto (3×)").is_present);
    CHECK(menu_entry_of(sections(), "Source: Shape: Square pixels").is_present);
    take(menu_entry_of(sections(), "Source: Shape: 4:3").commands, document);
    CHECK(document.state().source == "game.png,fit=whole,shape=4:3,prescaled=auto");
    CHECK(menu_entry_of(sections(), "Source: Shape: 4:3").is_present);
    take(menu_entry_of(sections(), "Source: Pre-scaled: 2×").commands, document);
    CHECK(document.state().source == "game.png,fit=whole,shape=4:3,prescaled=2");
    take(menu_entry_of(sections(), "Source: Shape: Custom").commands, document);
    CHECK(parse_source(document.state().source)->aspect == doctest::Approx(7.0 / 6.0));
    CHECK(menu_entry_of(sections(), "Source: Shape: Custom").is_present);
    set_source(document, "game.png,shape=16:10");
    CHECK(menu_entry_of(sections(), "Source: Shape: 16:10").is_present);
    set_source(document, "game.png,shape=16:10,prescaled=auto");
    const PatternInfo& pattern = all_patterns().back();
    take(menu_entry_of(sections(), "Source: " + pattern.label).commands, document);
    CHECK(document.state().source == "pattern:" + pattern.name + ",shape=16:10");
}

TEST_CASE("looks are added, moved, bypassed and removed by name") {
    Document document(menu_look(Driver::signal));
    const std::vector<ListedLook> looks{listed_look("phosphor", "Phosphor"),
                                        listed_look("crt", "CRT")};
    const auto stack = [&]() -> const Stack& { return document.state().stack; };
    const auto choose = [&](const std::string& label) {
        take(menu_entry_of({stack_section(stack(), looks)}, "Stack: " + label).commands, document);
    };
    CHECK_FALSE(find_menu_entry({stack_section(stack(), looks)}, "Stack: Remove Phosphor"));
    choose("Add CRT");
    choose("Add CRT");
    CHECK(stack_id(stack()) == "phosphor+crt+crt");
    CHECK(document.history().undo_name() == "Add CRT");
    choose("Move CRT 2 earlier");
    choose("Move Phosphor later");
    CHECK(stack_id(stack()) == "crt+phosphor+crt");
    choose("Bypass Phosphor");
    CHECK(stack()[1].is_bypassed);
    choose("Bypass Phosphor");
    CHECK_FALSE(stack()[1].is_bypassed);
    choose("Remove Phosphor");
    CHECK(stack_id(stack()) == "crt+crt");
    document.undo();
    CHECK(stack_id(stack()) == "crt+phosphor+crt");
}

TEST_CASE("the inspected texture, channels and levels can be chosen by name") {
    const TextureChoice past{Input::From::pass, "beam", 1, 0};
    const InspectedParts parts{{{Input::From::pass, "beam"},
                                {Input::From::source, "source"},
                                {Input::From::image, "noise"}},
                               past,
                               3,
                               2};
    WindowState window;
    window.views.inspected.inspect(past);
    const auto sections = inspector_sections(parts, window.views.inspected);
    CHECK(menu_entry_of(sections, "Inspect: beam, 1 frame ago").is_present);
    CHECK(find_menu_entry(sections, "Inspect: beam, 2 frames ago"));
    CHECK_FALSE(find_menu_entry(sections, "Inspect: beam, 3 frames ago"));
    take(menu_entry_of(sections, "Inspect: noise").commands, window);
    CHECK(window.views.inspected.label() == "noise");
    take(menu_entry_of(sections, "Channels: Red as grey").commands, window);
    CHECK(window.views.inspected.channels == Channels::red);
    take(menu_entry_of(sections, "Inspect: White point…").number->answer(4.0), window);
    take(menu_entry_of(sections, "Inspect: Black point…").number->answer(0.5), window);
    CHECK(window.views.inspected.levels == Levels{0.5, 4.0});
}

TEST_CASE("a colour component can be typed, and a parameter locked, by name") {
    Document document(menu_look(Driver::signal));
    const auto sections = parameter_sections(document, document.look().parameters.front());
    const std::string blue = component_label(document.look().parameters.front(), 2);
    take(menu_entry_of(sections, "Tint: " + blue + "…").number->answer(0.25), document);
    CHECK(document.value(document.look().parameters.front()).numbers ==
          std::vector<double>{1.0, 1.0, 0.25});
    take(menu_entry_of(sections, "Tint: Locked").commands, document);
    CHECK(document.parameter_settings().at("tint").is_locked);
    CHECK_FALSE(find_menu_entry(parameter_list_sections(Document(menu_look(Driver::signal)), {}),
                                "Parameters: Reset Glass"));
    take(menu_entry_of(sections, "Tint: Locked").commands, document);
    take(menu_entry_of(parameter_sections(document, document.look().parameters.front()),
                       "Tint: Locked")
             .commands,
         document);
    take(menu_entry_of(parameter_list_sections(document, {}), "Parameters: Reset Glass").commands,
         document);
    CHECK(document.values().empty());
}

TEST_CASE("panes are resized by name, within their limits") {
    WindowState window;
    const auto sections = window_sections(window, {{}, ViewShape::view, {320, 180}});
    const double before = window.layout.sizes.left;
    take(menu_entry_of(sections, "Pane: Widen left pane").commands, window);
    CHECK(window.layout.sizes.left == before + 40.0);
    for (int i = 0; i < 20; ++i)
        take(menu_entry_of(sections, "Pane: Widen left pane").commands, window);
    CHECK(window.layout.sizes.left == 520.0);
    take(menu_entry_of(sections, "Waveform: Row…").number->answer(20.0), window);
    CHECK(window.probes.scan_line.row({320, 180}) == 20);
    CHECK(window.layout.sees(panel_id::waveform));
    take(menu_entry_of(sections, "Pins: Pin picture centre").commands, window);
    CHECK(window.probes.pins == std::vector<Pin>{{0.5, 0.5}});
}

TEST_CASE("two words find a menu entry, and actions rank first among equal matches") {
    Document document(menu_look(Driver::signal));
    WindowState window;
    std::vector<MenuSection> sections = signal_sections(document);
    sections.push_back(stack_section(document.state().stack, {listed_look("mask", "Shadow mask")}));
    for (const MenuSection& section :
         inspector_sections({{{Input::From::source, "source"}}, {}, 1, 1}, window.views.inspected))
        sections.push_back(section);
    for (const MenuSection& section : window_sections(window, {{}, ViewShape::view, {320, 180}}))
        sections.push_back(section);
    sections.push_back({"Presets", MenuSection::Menu::palette, {{.name = "Favourites only"}}});
    std::vector<PaletteEntry> entries{
        {PaletteEntry::Kind::action, "Zoom in", "Zoom in", "View", {}, {}, {}},
        {PaletteEntry::Kind::action, "Inspector", "Inspector", "View", {}, {}, {}},
        {PaletteEntry::Kind::action, "Fav", "Show only favourites", "Edit", {}, {}, {}}};
    for (PaletteEntry& entry : section_entries(sections))
        entries.push_back(std::move(entry));
    CHECK(first_found(entries, "signal wave") == "Signal: " + find_kind("waveform")->label);
    CHECK(first_found(entries, "add shadow") == "Stack: Add Shadow mask");
    CHECK(first_found(entries, "red green") == "Channels: Red, green and blue");
    CHECK(first_found(entries, "red grey") == "Channels: Red as grey");
    CHECK(first_found(entries, "insp source") == "Inspect: source");
    CHECK(first_found(entries, "inspector") == "Inspector");
    CHECK(first_found(entries, "zoom") == "Zoom in");
    CHECK(first_found(entries, "favourites") == "Show only favourites");
    CHECK(first_found(entries, "widen left") == "Pane: Widen left pane");
    std::vector<std::string> labels;
    for (const PaletteEntry& entry : entries)
        labels.push_back(entry.label);
    std::ranges::sort(labels);
    CHECK(std::ranges::adjacent_find(labels) == labels.end());  // each name is unique
}

TEST_CASE("sound and remote control settings can be chosen by name") {
    SoundControls info;
    info.devices = {{.name = "Scope"}};
    info.devices.front().has_output = true;
    const MenuSection sound = sound_section(info);
    CHECK(menu_entry_of({sound}, "Sound: Output: System default").is_present);
    CHECK(find_menu_entry({sound}, "Sound: Output: Scope"));
    CHECK_FALSE(find_menu_entry({sound}, "Sound: Input: Scope"));
    CHECK_FALSE(find_menu_entry({sound}, "Sound: Volume…"));
    info.sound_seconds = 12.0;
    CHECK(menu_entry_of({sound_section(info)}, "Sound: Go to…").number->limit == Limit{0.0, 12.0});
    RemoteSettings settings;
    settings.bind({.goal = {"decay"}, .channel = 1, .controller = 21});
    const MenuSection remote = remote_section(settings, true, false);
    CHECK(menu_entry_of({remote}, "Remote: Listen to OSC").is_present);
    CHECK(find_menu_entry({remote}, "Remote: Unmap decay (CC 21, channel 1)"));
}

TEST_CASE("presets are morphed to, starred and searched by name") {
    ListedPreset plain;
    plain.preset.name = "Phosphor";
    ListedPreset amber;
    amber.preset.name = "Amber";
    amber.preset.entry.file = "/presets/amber.json";
    amber.has_star = true;
    const auto sections = preset_sections({plain, amber}, {});
    CHECK(find_menu_entry(sections, "Morph: To Amber"));
    CHECK(menu_entry_of(sections, "Morph: Duration 3 s").is_present);
    CHECK(menu_entry_of(sections, "Star: Amber").is_present);
    CHECK_FALSE(find_menu_entry(sections, "Star: Phosphor"));  // the look's defaults
    WindowState window;
    take(menu_entry_of(sections, "Presets: Search…").text->answer("amb"), window);
    CHECK(window.presets.search == "amb");
    CHECK(window.layout.sees(panel_id::presets));
}
