#include "lab/menus/palette.h"

#include "base/fuzzy.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <tuple>

namespace {
using Kind = PaletteEntry::Kind;

void add_presets(const ListedLook& look, std::vector<PaletteEntry>& entries) {
    for (const ListedLookPreset& preset : look.presets) {
        const std::string file = preset.entry.file.string();
        entries.push_back(
            {Kind::preset,
             "preset:" + file,
             fmt::format("Preset: {}", preset.name),
             preset.entry.is_shipped ? look.name : fmt::format("{} · yours", look.name),
             file,
             {},
             {}});
    }
}

void add_parts(const Look& look, std::vector<PaletteEntry>& entries) {
    for (const Pass& pass : look.passes)
        entries.push_back({Kind::pass,
                           "pass:" + pass.name,
                           fmt::format("Pass: {}", pass.name),
                           "Inspect",
                           pass.name,
                           {},
                           {}});
    for (const Parameter& parameter : look.parameters)
        if (!parameter.is_hidden)
            entries.push_back({Kind::parameter,
                               "parameter:" + parameter.name,
                               fmt::format("Parameter: {}", parameter.label),
                               heading_of(look, parameter),
                               parameter.name,
                               {},
                               {}});
}

// The start of the name, after the kind and the colon.
std::size_t name_start(const PaletteEntry& entry) {
    return entry.kind == Kind::action ? 0 : entry.label.find(':') + 2;
}

struct Ranked {
    // smallest first
    std::tuple<int, bool, std::size_t, bool, std::size_t, std::size_t> order;
    PaletteMatch match;
};

// A match that needs the detail has a lower score.
std::optional<FuzzyMatch> fit(const PaletteEntry& entry, std::string_view query) {
    constexpr int for_kind = 5;  // matches only the kind, not the name
    constexpr int for_detail = 12;
    if (auto match = fuzzy_match(query, entry.label)) {
        if (!match->positions.empty() && match->positions.back() < name_start(entry))
            match->score -= for_kind;
        return match;
    }
    auto match = fuzzy_match(query, entry.label + ' ' + entry.detail);
    if (!match)
        return match;
    match->score -= for_detail;
    std::erase_if(match->positions, [&](std::size_t index) { return index >= entry.label.size(); });
    return match;
}
}  // namespace

std::vector<PaletteEntry> palette_entries(const Look* open, const std::vector<ListedLook>& looks) {
    std::vector<PaletteEntry> entries;
    const auto is_open = [open](const ListedLook& look) {
        return open && look.entry.id == open->id;
    };
    for (const ListedLook& look : looks)
        if (is_open(look))
            add_presets(look, entries);
    if (open)
        add_parts(*open, entries);
    for (const ListedLook& look : looks)
        entries.push_back({Kind::look,
                           "look:" + look.argument(),
                           fmt::format("Look: {}", look.name),
                           {},
                           look.argument(),
                           {},
                           {}});
    for (const ListedLook& look : looks)
        if (!is_open(look))
            add_presets(look, entries);
    return entries;
}

std::vector<PaletteEntry> section_entries(const std::vector<MenuSection>& sections) {
    std::vector<PaletteEntry> entries;
    std::set<std::string> labels;
    for (const MenuSection& section : sections)
        for (const MenuEntry& entry : section.entries) {
            const std::string label = section.label_of(entry);
            if (labels.insert(label).second)
                entries.push_back({Kind::menu_entry,
                                   label,
                                   label,
                                   entry.is_present ? "current" : "",
                                   {},
                                   {},
                                   {},
                                   entry});
        }
    return entries;
}

std::vector<PaletteEntry> file_entries(const std::vector<std::string>& recent) {
    std::vector<PaletteEntry> entries;
    for (const std::string& file : recent) {
        const std::filesystem::path path(file);
        entries.push_back({Kind::file,
                           "file:" + file,
                           fmt::format("File: {}", path.filename().string()),
                           path.parent_path().string(),
                           file,
                           {},
                           {}});
    }
    return entries;
}

std::vector<PaletteEntry> difference_entries(const Look& open,
                                             const std::vector<ListedLook>& looks) {
    std::vector<PaletteEntry> entries;
    for (const ListedLook& look : looks)
        for (const ListedLookPreset& preset : look.presets)
            if (look.entry.id == open.id)
                entries.push_back({Kind::difference,
                                   "difference:" + preset.name,
                                   fmt::format("Differences: {}", preset.name),
                                   "compared with the current settings",
                                   preset.entry.file.string(),
                                   {},
                                   {}});
    return entries;
}

std::vector<PaletteMatch> find_entries(const std::vector<PaletteEntry>& entries,
                                       std::string_view query,
                                       const std::vector<std::string>& used) {
    std::vector<Ranked> ranked;
    for (std::size_t i = 0; i < entries.size(); ++i) {
        const auto match = fit(entries[i], query);
        if (!match)
            continue;
        const auto use = std::find(used.begin(), used.end(), entries[i].id);
        const std::size_t start = name_start(entries[i]);
        const bool is_named = !match->positions.empty() && match->positions.back() >= start;
        // A file replaces what is open, so a command that matches as well comes first.
        const bool is_typed_file = entries[i].kind == Kind::file && !query.empty();
        ranked.push_back(
            {{-match->score, is_typed_file, static_cast<std::size_t>(use - used.begin()),
              entries[i].kind == Kind::menu_entry, is_named ? entries[i].label.size() - start : 0,
              i},
             {i, match->positions}});
    }
    std::sort(ranked.begin(), ranked.end(),
              [](const Ranked& a, const Ranked& b) { return a.order < b.order; });
    std::vector<PaletteMatch> matches;
    for (Ranked& one : ranked)
        matches.push_back(std::move(one.match));
    return matches;
}

void note_use(std::vector<std::string>& used, const std::string& id) {
    constexpr std::size_t maximum = 20;
    if (!used.empty() && used.front() == id)
        return;
    std::erase(used, id);
    used.insert(used.begin(), id);
    if (used.size() > maximum)
        used.resize(maximum);
}
