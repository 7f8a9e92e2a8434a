#include "lab/commands/preset_sharing.h"

#include "formats/preset/fitted_preset.h"
#include "formats/preset/preset_format.h"
#include "formats/preset/share_line.h"
#include "formats/slang/slang_format.h"
#include "formats/slang_export/simple_slang_preset.h"
#include "io/files/atomic_file.h"
#include "lab/document/opened_preset.h"
#include "lab/document/parameter_edits.h"
#include "lab/document/sharing.h"
#include "lab/storage/display_name.h"

#include <fmt/format.h>

#include <algorithm>

namespace fs = std::filesystem;

std::string PresetSharing::line() const {
    return m_work.document ? share_line_of(*m_work.document, m_work.media.recent()) : std::string();
}

void PresetSharing::apply_fitted(const Preset& preset, const fs::path& file, const char* step) {
    Diagnostics warnings;
    const Preset fitted = fitted_preset(m_work.document->look(), preset, file, warnings);
    apply_preset(*m_work.document, fitted, step);
    if (!warnings.empty())
        m_work.messages.say(warnings.front());
}

void PresetSharing::paste(const std::string& line) {
    const auto preset = parse_share_line(line);
    if (!m_work.messages.succeeded(preset))
        return;
    if (m_work.document && preset->look == m_work.document->look().id) {
        const CheckedPreset checked = with_checked_media(*preset, m_work.document->look(),
                                                         fs::current_path(), m_work.media.recent());
        apply_fitted(checked.preset, {}, "Paste");
        return m_content.offer(checked);
    }
    const auto request = resolve(line, m_work.library);
    if (m_work.messages.succeeded(request))
        m_loader.open(*request);
}

bool PresetSharing::can_save_slang() const {
    return m_work.document && m_work.document->look().stack.size() <= 1 &&
           is_slang_file(m_work.document->look().manifest);
}

void PresetSharing::save_slang(const fs::path& given) {
    if (!can_save_slang())
        return m_work.messages.say("Only RetroArch looks can be saved as .slangp", true);
    const fs::path file =
        given.extension() == ".slangp" ? given : fs::path(given.string() + ".slangp");
    const Look& look = m_work.document->look();
    std::error_code error;
    if (fs::equivalent(file, look.manifest, error))
        return m_work.messages.say("A .slangp file can't reference itself. Choose another name.",
                                   true);
    const auto is_read = [&](const fs::path& read) { return fs::equivalent(file, read, error); };
    if (std::ranges::any_of(m_loader.files().look_files(), is_read))
        return m_work.messages.say("The open look uses this file. Choose another name.", true);
    std::map<std::string, double> values;
    std::string left_out;
    for (const Parameter& parameter : look.parameters)
        if (is_changed(*m_work.document, parameter) && parameter.is_constant)
            left_out += (left_out.empty() ? "" : ", ") + parameter.label;
        else if (is_changed(*m_work.document, parameter))
            values[parameter.name] = m_work.document->value(parameter).number();
    if (!m_work.messages.succeeded(
            write_atomically(file, simple_slang_preset(look.manifest, values, file))))
        return;
    const std::string name = file.filename().string();
    m_work.messages.say(
        left_out.empty()
            ? saved_text(name)
            : fmt::format("Saved \"{}\". A .slangp file can't store {}.", name, left_out));
}

void PresetSharing::file_changed(const fs::path& file) {
    const auto preset = load_preset(file);
    if (!m_work.messages.succeeded(preset))
        return;
    m_work.messages.withdraw(file.string());
    const Preset current = portable_preset_of(*m_work.document, file, m_work.media.recent());
    if (is_written_alike(*preset, current, m_work.document->look()))
        return;
    if (is_modified(*m_work.document)) {
        m_work.messages.say(fmt::format("\"{}\" changed on disk. Your changes are kept.",
                                        preset_name(*m_work.document)),
                            true);
        return;
    }
    const CheckedPreset checked = with_checked_media(*preset, m_work.document->look(),
                                                     media_folder(file), m_work.media.recent());
    apply_fitted(checked.preset, file, "Preset changed on disk");
    DocumentState saved = m_work.document->state();
    saved.signal = checked.preset.signal.value_or(saved.signal);
    saved.source = checked.preset.source.empty() ? saved.source : checked.preset.source;
    opened_preset(*m_work.document).saved = std::move(saved);
    if (checked.outside)
        m_content.offer(checked);
}
