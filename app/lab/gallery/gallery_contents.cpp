#include "lab/gallery/gallery_contents.h"

#include "base/text.h"
#include "formats/look_format.h"
#include "formats/preset/share_line.h"
#include "lab/document/opened_preset.h"
#include "lab/golden/golden_name.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <set>

namespace fs = std::filesystem;

namespace {
/// Collects the groups of a gallery.
class GalleryCollector {
public:
    explicit GalleryCollector(const Library& library) : m_library(library) {}

    void add(const std::string& argument);
    Result<std::vector<GalleryGroup>> finish(Diagnostics& problems);

private:
    GalleryGroup& group_of(const Look& look);
    void add_look(const std::string& argument);
    void add_preset(const std::string& argument, const OpenRequest& request);
    void add_item(GalleryItem item);
    void add_errors(Diagnostics errors, const std::string& argument);
    std::string unique_stem(const std::string& stem);

    const Library& m_library;
    std::vector<GalleryGroup> m_groups;
    std::set<std::string> m_stems;  // lower case
    Diagnostics m_errors;
};

// The same looks, bypassed or not.
bool has_same_looks(const Stack& one, const Stack& other) {
    return std::ranges::equal(one, other, {}, &StackPart::path, &StackPart::path);
}

GalleryGroup& GalleryCollector::group_of(const Look& look) {
    const auto found = std::ranges::find_if(m_groups, [&](const GalleryGroup& group) {
        return has_same_looks(group.look.stack, look.stack);
    });
    if (found != m_groups.end())
        return *found;
    m_groups.push_back({look, {}});
    return m_groups.back();
}

std::string GalleryCollector::unique_stem(const std::string& stem) {
    std::string unique = stem;
    for (int number = 2; !m_stems.insert(to_lower(unique)).second; ++number)
        unique = fmt::format("{}-{}", stem, number);
    return unique;
}

void GalleryCollector::add_errors(Diagnostics errors, const std::string& argument) {
    for (Diagnostic& error : errors) {
        if (error.file.empty())
            error.file = argument;
        add_new(m_errors, std::move(error));
    }
}

void GalleryCollector::add_item(GalleryItem item) {
    GalleryGroup& group = group_of(item.prepared.document.look());
    const auto is_same = [&](const GalleryItem& other) {
        return other.file == item.file && other.line == item.line;
    };
    if (std::ranges::any_of(group.items, is_same))
        return;
    const bool is_look = item.file.empty() && item.line.empty();
    const std::string named = item.file.empty() ? item.name : item.file.stem().string();
    const std::string preset = named.empty() && !is_look ? "unnamed" : named;
    item.stem = unique_stem(golden_name(group.look.id, preset));
    if (item.name.empty())
        item.name = is_look ? "Default" : named.empty() ? "Unnamed" : named;
    group.items.push_back(std::move(item));
}

void GalleryCollector::add_preset(const std::string& argument, const OpenRequest& request) {
    auto prepared = prepare({.look = argument}, m_library);
    if (!prepared)
        return add_errors(prepared.error(), argument);
    std::string name = preset_name(prepared->document);
    const bool is_line = is_share_line(argument);
    add_item({std::move(*prepared),
              is_line ? fs::path() : request.preset_file,
              is_line ? argument : std::string(),
              std::move(name),
              {}});
}

// Presets in the order of the window's list.
void GalleryCollector::add_look(const std::string& argument) {
    auto plain = prepare({.look = argument}, m_library);
    if (!plain)
        return add_errors(plain.error(), argument);
    const std::string id = plain->document.look().id;
    add_item({std::move(*plain), {}, {}, {}, {}});
    struct Listed {
        PresetEntry entry;
        GalleryItem item;
    };
    std::vector<Listed> presets;
    for (const PresetEntry& entry : m_library.presets(id)) {
        auto prepared = prepare({.look = argument, .preset = entry.file.string()}, m_library);
        if (!prepared) {
            add_errors(prepared.error(), entry.file.string());
            continue;
        }
        std::string name = preset_name(prepared->document);
        if (name.empty())
            name = entry.name;
        presets.push_back({entry, {std::move(*prepared), entry.file, {}, std::move(name), {}}});
    }
    std::ranges::sort(presets, [](const Listed& one, const Listed& other) {
        return is_listed_before(one.entry, one.item.name, other.entry, other.item.name);
    });
    for (Listed& preset : presets)
        add_item(std::move(preset.item));
}

void GalleryCollector::add(const std::string& argument) {
    const auto request = resolve(argument, m_library);
    if (!request)
        add_errors(request.error(), argument);
    else if (request->preset)
        add_preset(argument, *request);
    else
        add_look(argument);
}

Result<std::vector<GalleryGroup>> GalleryCollector::finish(Diagnostics& problems) {
    std::erase_if(m_groups, [](const GalleryGroup& group) { return group.items.empty(); });
    if (m_groups.empty() && !m_errors.empty())
        return fail(std::move(m_errors));
    problems = std::move(m_errors);
    return std::move(m_groups);
}

std::vector<std::string> all_looks(const Library& library) {
    std::vector<std::string> arguments;
    for (const LookEntry& look : library.looks())
        arguments.push_back(look.folder.string());
    std::ranges::copy(library.stacks(), std::back_inserter(arguments));
    return arguments;
}
}  // namespace

Result<std::vector<GalleryGroup>> gallery_contents(const std::vector<std::string>& arguments,
                                                   const Library& library, Diagnostics& problems) {
    GalleryCollector collector(library);
    for (const std::string& argument : arguments.empty() ? all_looks(library) : arguments)
        collector.add(argument);
    return collector.finish(problems);
}
