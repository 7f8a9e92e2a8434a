#include "lab/commands/matched_preset.h"

#include "lab/document/opened_preset.h"
#include "lab/document/output_name.h"

#include <filesystem>

void save_matched_preset(const PhotoMatcher& matcher, Document& document, PresetCommands& presets,
                         Messages& messages) {
    if (!matcher.photo())
        return;
    matcher.apply(document);
    const std::string stem = matcher.photo()->file.stem().string() + " matched";
    const std::filesystem::path name = unused_name(presets.destination(), stem, ".json");
    presets.save_as(name.stem().string());
    if (preset_file(document).filename() == name)
        messages.succeeded(matcher.attach_to(preset_file(document)));
}
