#include "lab/library/library.h"

#include "base/file.h"
#include "base/text.h"
#include "formats/foreign_format.h"
#include "formats/look/loaded_look.h"
#include "formats/preset/preset_format.h"
#include "formats/preset/preset_update.h"
#include "io/files/atomic_file.h"
#include "lab/library/look_templates.h"
#include "lab/storage/name_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <set>
#include <tuple>
#include <utility>

namespace fs = std::filesystem;

namespace {
std::vector<fs::path> sorted_entries(const fs::path& folder) {
    std::vector<fs::path> entries;
    std::error_code error;
    for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error))
        entries.push_back(it->path());
    std::sort(entries.begin(), entries.end());
    return entries;
}

// The problem of a name with the name itself, for messages outside a dialog.
Result<void> checked(const NameCheck& check, std::string_view name, const char* what) {
    if (check.is_valid)
        return {};
    const std::string problem = check.problem.empty() ? "Type a name." : check.problem;
    return fail({{}, 0, fmt::format("'{}' can't be {}. {}", name, what, problem)});
}

Diagnostic preset_exists(std::string_view name) {
    return {{}, 0, fmt::format("a preset called '{}' already exists", name)};
}

template <class Entry>
void add_or_shadow(std::vector<Entry>& entries, Entry entry, std::string Entry::*key) {
    const auto same = std::find_if(entries.begin(), entries.end(),
                                   [&](const Entry& e) { return e.*key == entry.*key; });
    if (same == entries.end())
        entries.push_back(std::move(entry));
    else
        *same = std::move(entry);
}
// A look of another program is in a folder with the name of its file, at any depth:
// shaders/glow.slangp/crt/glow.slangp. "": none.
fs::path foreign_file_in(const fs::path& folder) {
    const std::vector<std::string> extensions = foreign_extensions();
    const std::string extension = to_lower(folder.extension().string());
    if (std::ranges::find(extensions, extension) == extensions.end())
        return {};
    const fs::path name = foreign_file_name(folder.filename().string());
    std::error_code error;
    for (fs::recursive_directory_iterator entry(folder, error), end; !error && entry != end;
         entry.increment(error))
        if (entry->path().filename() == name && entry->is_regular_file(error))
            return entry->path();
    return {};
}
}  // namespace

bool is_listed_before(const PresetEntry& one, std::string_view one_name, const PresetEntry& other,
                      std::string_view other_name) {
    const auto key = [](const PresetEntry& preset, std::string_view name) {
        const bool is_article = preset.is_shipped && preset.name.starts_with("article");
        return std::tuple(preset.is_shipped, is_article, to_lower(name), preset.name);
    };
    return key(one, one_name) < key(other, other_name);
}

Library Library::with(std::vector<LookEntry> added) const {
    Library more = *this;
    more.m_added.insert(more.m_added.end(), std::make_move_iterator(added.begin()),
                        std::make_move_iterator(added.end()));
    return more;
}

std::vector<LookEntry> Library::looks() const {
    std::vector<LookEntry> looks;
    std::error_code error;
    for (const fs::path& root : m_roots.all())
        for (const fs::path& folder : sorted_entries(root / "shaders")) {
            if (fs::is_regular_file(folder / "look.json", error))
                add_or_shadow(looks, {folder.filename(), folder, is_shipped(folder / "look.json")},
                              &LookEntry::id);
            else if (const fs::path file = foreign_file_in(folder); !file.empty())
                add_or_shadow(looks, {folder.filename(), file, false, folder}, &LookEntry::id);
        }
    for (const LookEntry& look : m_added)
        add_or_shadow(looks, look, &LookEntry::id);
    return looks;
}

bool Library::is_shipped(const fs::path& file) const {
    return ::is_shipped(*m_shipped, m_roots.program, file);
}

std::vector<PresetEntry> Library::presets(std::string_view look) const {
    std::vector<PresetEntry> presets;
    for (const fs::path& root : m_roots.all())
        for (const fs::path& file : sorted_entries(root / "presets" / look))
            if (file.extension() == ".json" && file.stem().extension() != ".camera")
                presets.push_back(
                    {std::string(look), file.stem(), file, is_shipped(file), file.stem()});
    std::ranges::stable_sort(presets, {}, [](const PresetEntry& preset) {
        return std::pair(preset.is_shipped, preset.name);
    });
    std::set<std::string> taken;
    for (PresetEntry& preset : presets)
        if (preset.is_shipped)
            taken.insert(preset.name);
    for (PresetEntry& preset : presets)
        if (!preset.is_shipped && !taken.insert(preset.name).second)
            preset.id = "user:" + preset.name;
    return presets;
}

std::vector<PresetEntry> Library::presets_in_program_folder() const {
    std::vector<PresetEntry> found;
    std::error_code error;
    if (fs::equivalent(m_roots.program, m_roots.user, error))
        return found;
    for (const fs::path& folder : sorted_entries(m_roots.program / "presets"))
        for (const PresetEntry& preset : presets(folder.filename().string()))
            if (!preset.is_shipped && preset.file.parent_path() == folder)
                found.push_back(preset);
    return found;
}

Result<fs::path> Library::move_to_user_folder(const PresetEntry& preset) const {
    auto path = preset_path(preset.look, preset.name);
    std::error_code error;
    for (int n = 2; path && fs::exists(*path, error); ++n)
        path = preset_path(preset.look, fmt::format("{} {}", preset.name, n));
    if (!path)
        return path;
    const auto text = read_bytes(preset.file);
    if (!text)
        return fail(text.error());
    // Copied, because the folders can be on different volumes.
    if (auto written = write_atomically(*path, *text); !written)
        return fail(written.error());
    fs::remove(preset.file, error);
    if (error)
        return fail({preset.file, 0,
                     fmt::format("was copied to your presets, but the original can't be deleted: "
                                 "{}",
                                 error.message())});
    return path;
}

std::vector<std::string> Library::stacks() const {
    std::vector<std::string> stacks;
    std::error_code error;
    for (const fs::path& root : m_roots.all())
        for (const fs::path& folder : sorted_entries(root / "presets")) {
            const std::string id = folder.filename().string();
            if (id.find('+') != std::string::npos && fs::is_directory(folder, error) &&
                std::find(stacks.begin(), stacks.end(), id) == stacks.end())
                stacks.push_back(id);
        }
    return stacks;
}

std::optional<LookEntry> Library::find_look(std::string_view id) const {
    for (LookEntry& look : looks())
        if (look.id == id)
            return look;
    return std::nullopt;
}

std::optional<PresetEntry> Library::find_preset(std::string_view look,
                                                std::string_view name) const {
    constexpr std::string_view user = "user:";
    constexpr std::string_view shipped = "shipped:";
    const bool is_users = name.starts_with(user);
    const bool is_of_program = name.starts_with(shipped);
    const std::string_view bare = name.substr(is_users        ? user.size()
                                              : is_of_program ? shipped.size()
                                                              : 0);
    std::optional<PresetEntry> found;
    for (PresetEntry& preset : presets(look))
        if (preset.name == bare && !(is_users && preset.is_shipped) &&
            !(is_of_program && !preset.is_shipped) && (!found || preset.is_shipped))
            found = std::move(preset);
    return found;
}

Result<fs::path> Library::preset_path(std::string_view look, std::string_view name) const {
    if (auto checked_name = checked(check_preset_name(name), name, "a preset name"); !checked_name)
        return fail(checked_name.error());
    // The look name comes from the preset file. It must not contain a path to write to.
    if (look == ".." || look.find('/') != look.npos)
        return fail({{}, 0, fmt::format("'{}' can't be a look name", look)});
    return m_roots.user / "presets" / look / (std::string(name) + ".json");
}

Result<fs::path> Library::new_preset_path(std::string_view look, std::string_view name) const {
    auto file = preset_path(look, name);
    if (!file)
        return file;
    std::error_code error;
    if (fs::exists(*file, error))
        return fail(preset_exists(name));
    return file;
}

Result<fs::path> Library::save_preset(Preset preset, const std::string& name) const {
    auto file = new_preset_path(preset.look, name);
    if (!file)
        return file;
    if (preset.name.empty())
        preset.name = name;
    if (auto saved = ::save_preset(*file, preset); !saved)
        return fail(saved.error());
    return *file;
}

Result<fs::path> Library::rename_preset(const fs::path& file, const std::string& name) const {
    if (auto checked_name = checked(check_preset_name(name), name, "a preset name"); !checked_name)
        return fail(checked_name.error());
    if (is_shipped(file))
        return fail({file, 0, "is a shipped preset. Save it under a new name instead."});
    const fs::path renamed = file.parent_path() / (name + ".json");
    std::error_code error;
    if (renamed == file)
        return file;
    if (fs::exists(renamed, error))
        return fail(preset_exists(name));
    auto preset = load_preset(file);
    if (!preset)
        return fail(preset.error());
    preset->name = name;
    const auto text = read_text(file);
    if (!text)
        return fail(text.error());
    if (auto saved = write_atomically(renamed, updated_preset_text(*text, *preset, nullptr));
        !saved)
        return fail(saved.error());
    fs::remove(file, error);
    if (error)
        return fail(
            {file, 0,
             fmt::format("was renamed, but the old file can't be deleted: {}", error.message())});
    return renamed;
}

Result<fs::path> Library::duplicate_preset(const fs::path& file) const {
    auto preset = load_preset(file);
    if (!preset)
        return fail(preset.error());
    for (int n = 2;; ++n) {
        const std::string name = fmt::format("{} {}", file.stem().string(), n);
        const auto copy = preset_path(preset->look, name);
        if (copy && !new_preset_path(preset->look, name))
            continue;
        preset->name = name;
        return save_preset(std::move(*preset), name);
    }
}

Result<void> Library::check_look_name(const std::string& id) const {
    if (auto checked_name = checked(check_look_id(id), id, "a look name"); !checked_name)
        return checked_name;
    if (find_look(id))
        return fail({{}, 0, fmt::format("a look called '{}' already exists", id)});
    return {};
}

Result<fs::path> Library::new_look_folder(const std::string& id) const {
    if (auto checked_name = check_look_name(id); !checked_name)
        return fail(checked_name.error());
    const fs::path folder = m_roots.user / "shaders" / id;
    std::error_code error;
    if (fs::exists(folder, error) && !fs::is_empty(folder, error))
        return fail({folder, 0, "already exists and is not empty. Choose another name."});
    fs::create_directories(folder, error);
    if (error)
        return fail({folder, 0, error.message()});
    return folder;
}

Result<fs::path> Library::duplicate_look(const fs::path& folder, const std::string& id) const {
    auto copy = new_look_folder(id);
    if (!copy)
        return copy;
    std::error_code error;
    fs::copy(folder, *copy, fs::copy_options::recursive, error);
    if (error)
        return fail({*copy, 0, error.message()});
    fs::remove(*copy / picture_name, error);
    return *copy;
}

Result<fs::path> Library::new_look(const std::string& id, std::string_view template_id) const {
    const std::vector<LookTemplate> templates = look_templates(m_roots.program);
    const auto chosen = std::ranges::find(templates, template_id, &LookTemplate::id);
    if (chosen == templates.end())
        return fail({m_roots.program / "shaders" / "templates", 0,
                     fmt::format("has no template '{}'. Reinstall Afterglow.", template_id)});
    auto folder = new_look_folder(id);
    if (!folder)
        return folder;
    std::string words = id;
    std::ranges::replace(words, '-', '_');
    if (auto copied = copy_template(*chosen, *folder, label_from_name(words)); !copied)
        return fail(copied.error());
    return folder;
}
