#pragma once

#include "lab/media.h"
#include "model/preset.h"

#include <optional>
#include <string>

/// Content that a preset brings and that is used only where the user agrees: presets come from
/// others. It is a file outside of the preset's folder that was not opened lately, or a socket
/// outside of the runtime folder.
struct OutsideContent {
    std::string name;                           // the file or socket
    std::optional<Spec> signal = std::nullopt;  // that it would be used as
    std::string source = {};                    // likewise

    /// "the file '/tmp/a.png'".
    std::string words() const;
};

/// What with_found_media() gave for a preset of `folder`, without its content where that lies
/// outside; and that content.
struct CheckedPreset {
    Preset preset;
    std::optional<OutsideContent> outside = std::nullopt;
};

/// As with_found_media, and separates content that lies outside.
CheckedPreset with_checked_media(const Preset& preset, const std::filesystem::path& folder,
                                 const RecentMedia& recent);
