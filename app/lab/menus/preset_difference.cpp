#include "lab/menus/preset_difference.h"

#include "formats/preset/modulation_format.h"
#include "formats/preset/preset_format.h"
#include "lab/document/opened_preset.h"
#include "lab/media/preset_content.h"

std::vector<Change> difference_from(const Preset& preset, const Document& open) {
    Document other = open;
    open_preset(other, preset, {});
    return changes_between(open.look(), other.state(), open.state());
}

Result<std::vector<Change>> difference_from(const std::filesystem::path& preset_file,
                                            const Document& open, const RecentMedia& media) {
    auto preset = load_preset(preset_file);
    if (!preset)
        return fail(preset.error());
    if (auto fitted = fitted_values(open.look(), *preset, preset_file))
        preset->values = std::move(*fitted);
    if (auto fitted = fitted_modulations(open.look(), *preset, preset_file))
        preset->modulations = std::move(*fitted);
    const auto folder = media_folder(preset_file);
    Preset found = with_found_media(*preset, folder, media);
    return difference_from(with_found_files(std::move(found), open.look(), folder), open);
}
