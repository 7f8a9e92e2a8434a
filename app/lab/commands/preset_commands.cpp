#include "lab/commands/preset_commands.h"

#include "base/text.h"
#include "formats/preset/preset_format.h"
#include "io/system/file_status.h"
#include "lab/document/opened_preset.h"
#include "lab/document/sharing.h"
#include "lab/storage/display_name.h"
#include "lab/storage/name_check.h"
#include "lab/window/preset_list.h"

#include <fmt/format.h>

#include <algorithm>

namespace fs = std::filesystem;

namespace {
bool is_json(const fs::path& file) {
    return to_lower(file.extension().string()) == ".json";
}
}  // namespace

bool PresetCommands::can_save_over() const {
    const OpenDocument& document = m_work.document;
    return document && is_json(preset_file(*document)) &&
           !m_work.library.is_shipped(preset_file(*document));
}

std::string PresetCommands::proposed_name() const {
    const OpenDocument& document = m_work.document;
    if (!document)
        return {};
    std::string name = valid_preset_name(preset_name(*document));
    if (name.empty() || !m_work.library.is_shipped(preset_file(*document)))
        return name;
    for (int n = 1;; ++n) {
        std::string mine =
            n == 1 ? fmt::format("{} (mine)", name) : fmt::format("{} (mine {})", name, n);
        const auto path = m_work.library.preset_path(document->look().id, mine);
        std::error_code error;
        if (!path || !fs::exists(*path, error))
            return mine;
    }
}

fs::path PresetCommands::destination() const {
    const std::string look = m_work.document ? m_work.document->look().id : std::string();
    return m_work.library.roots().user / "presets" / look;
}

void PresetCommands::save() {
    OpenDocument& document = m_work.document;
    if (!document)
        return;
    if (!can_save_over())
        return m_work.messages.say("Give the preset a name first", true);
    save_to(preset_file(*document), preset_name(*document));
}

void PresetCommands::save_as(const std::string& name) {
    if (!m_work.document)
        return;
    const auto file = m_work.library.new_preset_path(m_work.document->look().id, name);
    if (m_work.messages.succeeded(file))
        save_to(*file, name);
}

void PresetCommands::replace(const std::string& name) {
    if (!m_work.document)
        return;
    const auto file = m_work.library.preset_path(m_work.document->look().id, name);
    if (m_work.messages.succeeded(file))
        save_to(*file, name);
}

void PresetCommands::save_to(const fs::path& file, const std::string& name) {
    Document& document = *m_work.document;
    Preset preset = portable_preset_of(document, file, m_work.media.recent());
    preset.name = name;
    if (!m_work.messages.succeeded(::save_preset(file, preset, &document.look())))
        return;
    opened_preset(document) = {preset, file, document.state()};
    m_loader.files().add_extra(file);  // it may change before the next update
    m_work.messages.say(saved_text(name));
}

bool PresetCommands::has_source_checkout() const {
    const fs::path& root = m_work.library.roots().program;
    std::error_code error;
    return fs::exists(root / "app" / "CMakeLists.txt", error) && is_writable(root / "presets");
}

void PresetCommands::save_into_shipped() {
    const OpenDocument& document = m_work.document;
    if (!document || preset_file(*document).empty())
        return m_work.messages.say("Open or save a preset first", true);
    const fs::path folder = m_work.library.roots().program / "presets" / document->look().id;
    save_to(folder / preset_file(*document).filename().replace_extension(".json"),
            preset_name(*document));
}

bool PresetCommands::is_open(const fs::path& file) const {
    return m_work.document && !file.empty() && is_open_preset(*m_work.document, file);
}

// As in the list of presets.
std::string PresetCommands::star_name(const fs::path& file) const {
    const std::string look = m_work.document ? m_work.document->look().id : std::string();
    for (const PresetEntry& preset : m_work.library.presets(look))
        if (preset.file == file)
            return favourite_key(look, preset.id);
    return favourite_key(look, file.stem().string());
}

void PresetCommands::rename(const fs::path& before, const std::string& name) {
    if (!m_work.document || before.empty())
        return;
    const std::string star = star_name(before);
    const std::vector<OpenedPreset*> open = presets_from_file(*m_work.document, before);
    const auto file = m_work.library.rename_preset(before, name);
    if (!m_work.messages.succeeded(file))
        return;
    if (m_navigation.stars().erase(star) > 0)
        m_navigation.stars().insert(star_name(*file));
    for (OpenedPreset* opened : open) {
        opened->identity.name = name;
        opened->file = *file;
    }
    m_work.messages.say(fmt::format("Renamed to \"{}\"", name));
}

void PresetCommands::duplicate(const fs::path& before) {
    if (!m_work.document || before.empty())
        return;
    const auto file = m_work.library.duplicate_preset(before);
    if (!m_work.messages.succeeded(file))
        return;
    const auto copy = load_preset(*file);
    if (is_open(before) && copy) {
        OpenedPreset& opened = opened_preset(*m_work.document);
        opened.identity.name = copy->name;
        opened.file = *file;
    }
    m_work.messages.say(
        fmt::format("Duplicated as \"{}\"", copy ? copy->name : file->stem().string()));
}

void PresetCommands::remove(const fs::path& file) {
    OpenDocument& document = m_work.document;
    if (!document || file.empty())
        return;
    if (m_work.library.is_shipped(file))
        return m_work.messages.say("Shipped presets can't be deleted", true);
    const auto preset = load_preset(file);
    const std::string star = star_name(file);
    const bool was_open = is_open(file);
    const auto trashed = move_to_trash(file);
    if (!m_work.messages.succeeded(trashed))
        return;
    if (m_loader.is_opening_preset(file))
        m_loader.cancel();
    Removal removal{
        .trashed = *trashed,
        .look = document->look().id,
        .name = preset ? preset->name : file.stem().string(),
        .has_star = m_navigation.stars().erase(star) > 0,
        .identity = was_open ? std::optional(opened_preset(*document).identity) : std::nullopt,
        .saved = opened_preset(*document).saved,
        .steps = document->history().past().size()};
    if (was_open) {
        opened_preset(*document) = {.saved = initial_state(document->look())};
    }
    m_work.messages.offer(
        was_open ? fmt::format("Deleted \"{}\". Its settings are still loaded.", removal.name)
                 : fmt::format("Deleted \"{}\"", removal.name),
        {.name = "Undo", .commands = {[this](Document&) { undo(); }}});
    m_removals.push_back(std::move(removal));
}

// The document's newer steps are undone first.
const PresetCommands::Removal* PresetCommands::last_removal() const {
    const OpenDocument& document = m_work.document;
    const bool is_next = document && !m_removals.empty() &&
                         m_removals.back().look == document->look().id &&
                         m_removals.back().steps == document->history().past().size();
    return is_next ? &m_removals.back() : nullptr;
}

std::string PresetCommands::undo_name() const {
    const Removal* removal = last_removal();
    return removal ? fmt::format("Delete \"{}\"", removal->name) : std::string();
}

void PresetCommands::undo() {
    if (!undo_removal() && m_work.document)
        m_work.document->undo();
}

bool PresetCommands::undo_removal() {
    if (!last_removal())
        return false;
    const Removal removal = std::move(m_removals.back());
    m_removals.pop_back();
    if (!m_work.messages.succeeded(restore_from_trash(removal.trashed)))
        return true;
    Document& document = *m_work.document;
    if (removal.has_star)
        m_navigation.stars().insert(star_name(removal.trashed.original));
    if (removal.identity && preset_file(document).empty()) {
        opened_preset(document) = {*removal.identity, removal.trashed.original, removal.saved};
    }
    m_work.messages.say(fmt::format("Restored \"{}\"", removal.name));
    return true;
}

void PresetCommands::show_in_folder(const fs::path& file) {
    m_work.programs.open_folder(file.parent_path());
}

void PresetCommands::offer_move() {
    const std::size_t count = m_work.library.presets_in_program_folder().size();
    if (count == 0)
        return;
    m_work.messages.offer(
        count == 1 ? "1 of your presets is in the program folder"
                   : fmt::format("{} of your presets are in the program folder", count),
        {.name = "Move to my presets", .commands = {[this] { move_to_user_folder(); }}});
}

void PresetCommands::move_to_user_folder() {
    std::size_t count = 0;
    for (const PresetEntry& preset : m_work.library.presets_in_program_folder()) {
        std::vector<OpenedPreset*> open;
        if (m_work.document)
            open = presets_from_file(*m_work.document, preset.file);
        const auto moved = m_work.library.move_to_user_folder(preset);
        if (!m_work.messages.succeeded(moved))
            return;
        ++count;
        for (OpenedPreset* opened : open)
            opened->file = *moved;
    }
    const std::string folder = display_folder(m_work.library.roots().user / "presets");
    m_work.messages.say(count == 1 ? fmt::format("Moved 1 preset to {}", folder)
                                   : fmt::format("Moved {} presets to {}", count, folder));
}
