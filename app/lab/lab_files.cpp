// The part of Lab that follows the files of a person besides the look's own.
#include "formats/preset/preset_format.h"
#include "lab/lab.h"
#include "lab/storage/include_store.h"
#include "lab/storage/media.h"

#include <fmt/format.h>

#include <utility>

namespace fs = std::filesystem;

void Lab::search_includes() {
    IncludeFolders folders = m_library.roots().include_folders();
    folders.named.insert(folders.named.end(), m_includes.begin(), m_includes.end());
    m_loader.worker().reader().set_include_folders(std::move(folders));
    m_loader.reload();
}

void Lab::set_include_folders(const std::vector<fs::path>& folders) {
    for (const fs::path& folder : folders) {
        std::error_code error;
        if (!fs::is_directory(folder, error))
            return m_messages.say(
                {folder, 0, "is not a folder. Includes are searched for in folders."});
    }
    m_includes = folders;
    m_messages.succeeded(save_include_folders(m_library.roots(), m_includes));
    search_includes();
}

void Lab::watch_extra_files() {
    std::vector<fs::path> files = m_chosen_images.files();
    for (const fs::path& file : m_variant_images.files())
        files.push_back(file);
    if (const fs::path& file = m_comparing.reference().file(); !file.empty())
        files.push_back(file);
    if (!m_document->preset_file().empty())
        files.push_back(m_document->preset_file());
    if (const fs::path file = driving_file(*m_document); file.is_absolute())
        files.push_back(file);
    m_loader.files().watch_extra(std::move(files));
}

void Lab::extra_file_changed(const fs::path& file) {
    if (!m_document)
        return;
    if (file == m_document->preset_file())
        preset_file_changed(file);
    const bool is_chosen = m_chosen_images.forget(file);
    if (m_variant_images.forget(file) || is_chosen)
        m_applied.reset();  // is read again, and a paused picture drawn again
    if (file == m_comparing.reference().file())
        reference_changed();
    if (file == driving_file(*m_document))
        m_drive.read_again(*m_document);
}

void Lab::preset_file_changed(const fs::path& file) {
    const auto preset = load_preset(file);
    if (!m_messages.succeeded(preset))
        return;
    m_messages.withdraw(file.string());
    const fs::path folder = media_folder(file);
    if (is_written_alike(*preset, portable(m_document->preset(), folder), m_document->look()))
        return;
    if (m_document->is_modified()) {
        m_messages.say(fmt::format("\"{}\" changed on disk. Your changes are kept.",
                                   m_document->preset_name()),
                       true);
        return;
    }
    const CheckedPreset checked =
        with_checked_media(*preset, m_document->look(), folder, m_drive.recent());
    m_document->take(checked.preset, "Preset changed on disk");
    DocumentState saved = m_document->state();
    saved.signal = checked.preset.signal.value_or(saved.signal);
    saved.source = checked.preset.source.empty() ? saved.source : checked.preset.source;
    m_document->mark_saved(std::move(saved));
    if (checked.outside)
        offer_content(checked);
}

void Lab::choose_picture(const std::string& parameter, const fs::path& file) {
    if (m_document)
        m_chosen_images.choose(m_document->look(), {parameter, file});
}

void Lab::take_chosen_images() {
    if (const auto chosen = m_chosen_images.take_chosen();
        chosen && m_messages.succeeded(*chosen)) {
        m_document->set_value((*chosen)->parameter, Value::of_path((*chosen)->file.string()));
        m_opened_files.add((*chosen)->file);
        m_drive.recent().remember((*chosen)->file, {});
    }
    Diagnostics problems;
    const auto names = m_chosen_images.take_read(m_document->look(), *m_renderer, problems);
    if (names.empty())
        return;
    if (!problems.empty())
        m_messages.say(problems.front());
    gather_problems();
    want(redraw_after(m_document->look(), names));
}
