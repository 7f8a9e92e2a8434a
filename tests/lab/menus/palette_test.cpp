#include "lab/menus/palette.h"

#include <doctest/doctest.h>

#include <algorithm>

namespace {
Parameter parameter(const char* name, const char* label, const char* group) {
    Parameter parameter;
    parameter.name = name;
    parameter.label = label;
    parameter.group = group;
    return parameter;
}

Look palette_look() {
    Look look;
    look.id = "phosphor";
    look.passes.resize(2);
    look.passes[0].name = "beam";
    look.passes[1].name = "bloom_x";
    look.parameters = {parameter("exposure_bias", "Exposure bias", "Camera"),
                       parameter("exposure", "Exposure", "Camera"),
                       parameter("bloom", "Bloom", "Glass"),
                       parameter("secret", "Secret", "Glass")};
    look.parameters.back().is_hidden = true;
    return look;
}

ListedLook listed_look(const char* id, const char* name, const char* preset) {
    ListedLook look;
    look.entry = {id, std::string("/looks/") + id, false};
    look.name = name;
    look.presets = {{{id, preset, std::string("/presets/") + id + '/' + preset, true}, preset, {}}};
    return look;
}

std::vector<ListedLook> library_view() {
    return {listed_look("crt", "CRT", "Amber"), listed_look("phosphor", "Phosphor", "Amber")};
}

std::vector<PaletteEntry> all_entries() {
    using Kind = PaletteEntry::Kind;
    std::vector<PaletteEntry> entries{
        {Kind::action, "Save preset as…", "Save preset as…", "File", {}, "Ctrl+Shift+S", {}},
        {Kind::action, "Save preset", "Save preset", "File", {}, "Ctrl+S", {}},
        {Kind::action, "Undo", "Undo: Exposure", "Edit", {}, "Ctrl+Z", {}},
        {Kind::action, "Darker", "One stop darker", "Pass", {}, "Shift+E", {}}};
    const Look look = palette_look();
    for (PaletteEntry& entry : palette_entries(&look, library_view()))
        entries.push_back(std::move(entry));
    return entries;
}

std::vector<std::string> found(const char* query, const std::vector<std::string>& used = {}) {
    const std::vector<PaletteEntry> entries = all_entries();
    std::vector<std::string> labels;
    for (const PaletteMatch& match : find_entries(entries, query, used))
        labels.push_back(entries[match.entry].label);
    return labels;
}
}  // namespace

TEST_CASE("the palette lists entries of the open look before other looks") {
    const Look look = palette_look();
    std::vector<std::string> labels;
    for (const PaletteEntry& entry : palette_entries(&look, library_view()))
        labels.push_back(entry.label + (entry.detail.empty() ? "" : " | " + entry.detail));
    CHECK(labels ==
          std::vector<std::string>{"Preset: Amber | Phosphor", "Pass: beam | Inspect",
                                   "Pass: bloom_x | Inspect", "Parameter: Exposure bias | Camera",
                                   "Parameter: Exposure | Camera", "Parameter: Bloom | Glass",
                                   "Look: CRT", "Look: Phosphor", "Preset: Amber | CRT"});
    CHECK(palette_entries(nullptr, library_view()).size() == 4);  // two looks with a preset each
}

TEST_CASE("typed text finds the closest name first") {
    CHECK(found("save").front() == "Save preset");  // the shorter name
    CHECK(found("spa").front() == "Save preset as…");
    CHECK(found("expo").front() == "Parameter: Exposure");
    CHECK(found("bias exp").front() == "Parameter: Exposure bias");
    CHECK(found("bloom").front() == "Parameter: Bloom");
    CHECK(found("pass bloom").front() == "Pass: bloom_x");
    CHECK(found("phos").front() == "Look: Phosphor");  // a name ranks before a detail
    CHECK(found("amber crt") == std::vector<std::string>{"Preset: Amber"});
    CHECK(found("undo").front() == "Undo: Exposure");
    CHECK(found("one stop").size() == 1);
    CHECK(found("xyz").empty());
    const auto kind = found("par");  // equal matches of a kind keep their order
    CHECK(std::vector<std::string>(kind.begin(), kind.begin() + 3) ==
          std::vector<std::string>{"Parameter: Exposure bias", "Parameter: Exposure",
                                   "Parameter: Bloom"});
}

TEST_CASE("an empty query lists recent entries first, then all in order") {
    const auto labels = found("", {"pass:beam", "Darker", "gone"});
    CHECK(labels.size() == all_entries().size());
    CHECK(std::vector<std::string>(labels.begin(), labels.begin() + 3) ==
          std::vector<std::string>{"Pass: beam", "One stop darker", "Save preset as…"});
}

TEST_CASE("among equal matches the most recently used one ranks first") {
    CHECK(found("expo", {"parameter:exposure_bias"}).front() == "Parameter: Exposure bias");
    CHECK(found("save p", {"Save preset as…", "Save preset"}).front() == "Save preset as…");
}

TEST_CASE("a command ranks before a recent file that matches as well") {
    std::vector<PaletteEntry> entries = file_entries({"/home/me/two.slangp"});
    const PaletteEntry file = entries.front();
    entries.push_back({PaletteEntry::Kind::action, "save", "Save as .slangp…", {}, {}, {}, {}});
    const auto first = [&](const char* query, const std::vector<std::string>& used) {
        return entries[find_entries(entries, query, used).front().entry].id;
    };
    CHECK(first("slangp", {file.id}) == "save");
    CHECK(first("two", {file.id}) == file.id);
    CHECK(first("", {file.id}) == file.id);
}

TEST_CASE("a reused id moves to the front, and at most 20 ids are kept") {
    std::vector<std::string> used;
    for (int i = 0; i < 30; ++i)
        note_use(used, std::to_string(i));
    note_use(used, "25");
    CHECK(used.size() == 20);
    CHECK(used.front() == "25");
    CHECK(std::count(used.begin(), used.end(), "25") == 1);
}
