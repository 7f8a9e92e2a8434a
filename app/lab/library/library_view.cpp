#include "lab/library/library_view.h"

#include "formats/look/look_manifest.h"
#include "formats/preset/preset_format.h"
#include "model/look/stack.h"

#include <algorithm>
#include <map>
#include <span>

namespace fs = std::filesystem;

namespace {
LibraryView::Texts read_look(const fs::path& file) {
    std::vector<fs::path> files;
    const auto look = load_manifest(file, files);
    return look ? LibraryView::Texts{{}, look->name, look->about}
                : LibraryView::Texts{{}, {}, to_string(look.error().front())};
}

LibraryView::Texts read_preset(const fs::path& file) {
    const auto preset = load_preset(file);
    return preset ? LibraryView::Texts{{}, preset->name, preset->about}
                  : LibraryView::Texts{{}, {}, to_string(preset.error().front())};
}

const std::string& file_name(const ListedLook& look) {
    return look.entry.id;
}

const std::string& file_name(const ListedLookPreset& preset) {
    return preset.entry.name;
}

// A copy can have the same name as its original, but has another file name.
template <class Entry>
void tell_apart(std::span<Entry> entries) {
    std::map<std::string, int> count;
    for (const Entry& entry : entries)
        ++count[entry.name];
    for (Entry& entry : entries)
        if (count[entry.name] > 1)
            entry.name += " (" + file_name(entry) + ")";
}
}  // namespace

std::string argument_of(const Look& look) {
    if (look.stack.size() > 1)
        return look.id;
    return (look.manifest.filename() == "look.json" ? look.manifest.parent_path() : look.manifest)
        .string();
}

bool is_listed_as(const Look& look, const ListedLook& entry) {
    return fs::path(argument_of(look)) == fs::path(entry.argument());
}

const LibraryView::Texts& LibraryView::texts_of(const fs::path& file, bool is_look) {
    std::error_code error;
    const fs::file_time_type written = fs::last_write_time(file, error);
    const auto known = m_texts.find(file);
    if (known != m_texts.end() && known->second.written == written)
        return known->second;
    Texts read = is_look ? read_look(file) : read_preset(file);
    if (read.name.empty() && known != m_texts.end())
        read.name = known->second.name;  // while the file is being edited
    read.written = written;
    return m_texts[file] = read;
}

void LibraryView::add_presets(ListedLook& look, const Library& library) {
    for (const PresetEntry& preset : library.presets(look.entry.id)) {
        const Texts& texts = texts_of(preset.file, false);
        look.presets.push_back(
            {preset, texts.name.empty() ? preset.name : texts.name, texts.about});
    }
    std::ranges::sort(look.presets, [](const ListedLookPreset& one, const ListedLookPreset& other) {
        return is_listed_before(one.entry, one.name, other.entry, other.name);
    });
    const auto shipped = std::ranges::find_if(
        look.presets, [](const auto& preset) { return preset.entry.is_shipped; });
    tell_apart(std::span(look.presets.begin(), shipped));
    tell_apart(std::span(shipped, look.presets.end()));
}

// Adds stacks whose looks are all available. Call it after all looks are listed.
void LibraryView::add_stacks(const Library& library) {
    const std::vector<ListedLook> looks = m_looks;
    for (const std::string& id : library.stacks()) {
        ListedLook stack{{id, {}, false}, {}, "A stack of looks.", {}};
        bool is_whole = true;
        for (const std::string& part : look_ids(id)) {
            const auto look = std::ranges::find_if(
                looks, [&](const ListedLook& known) { return known.entry.id == part; });
            is_whole = is_whole && look != looks.end();
            if (is_whole)
                stack.name += (stack.name.empty() ? "" : " + ") + look->name;
        }
        add_presets(stack, library);
        if (is_whole && !stack.presets.empty())
            m_looks.push_back(std::move(stack));
    }
}

void LibraryView::add_open(const Library& library, const Look& open) {
    const auto is_open = [&open](const ListedLook& entry) { return is_listed_as(open, entry); };
    if (std::ranges::any_of(m_looks, is_open))
        return;
    ListedLook entry{
        .entry = {}, .name = open.name, .about = open.manifest.string(), .presets = {}};
    entry.entry.id = open.id;
    if (open.stack.size() <= 1)
        entry.entry.folder = argument_of(open);
    add_presets(entry, library);
    m_looks.push_back(std::move(entry));
}

void LibraryView::update(const Library& library, const Look* open, double wall_seconds) {
    m_seconds_left -= wall_seconds;
    const std::string argument = open ? argument_of(*open) : std::string();
    if (m_seconds_left > 0.0 && m_open == argument)
        return;
    m_open = argument;
    m_seconds_left = 1.0;
    if (m_templates.empty())
        m_templates = look_templates(library.roots().program);
    m_looks.clear();
    for (const LookEntry& entry : library.looks()) {
        const bool is_foreign = !entry.foreign_folder.empty();
        const Texts texts = is_foreign ? Texts{{}, entry.folder.stem().string(), entry.id}
                                       : texts_of(entry.folder / "look.json", true);
        ListedLook look{entry, texts.name.empty() ? entry.id : texts.name, texts.about, {}};
        add_presets(look, library);
        m_looks.push_back(std::move(look));
    }
    tell_apart(std::span(m_looks));
    add_stacks(library);
    if (open)
        add_open(library, *open);
}
