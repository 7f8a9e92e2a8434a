#pragma once

#include "lab/storage/media.h"
#include "model/preset/preset.h"

#include <optional>
#include <string>

/// Content that a preset brings and that is used only where the user agrees: presets come from
/// others. Files outside the preset's folder count, unless they were opened lately; so does a
/// socket outside the runtime folder.
struct OutsideContent {
    std::string name = {};                      // the file or socket that drives the look; "": none
    std::optional<Spec> signal = std::nullopt;  // that it would be used as
    std::string source = {};                    // likewise
    Values files = {};                          // that parameters choose

    std::size_t count() const { return files.size() + (name.empty() ? 0 : 1); }
    /// For the window: what was not loaded.
    std::string notice() const;
    /// For the command line: with the options that allow it.
    std::string refusal() const;
    /// "file '/tmp/a.png', 2 more".
    std::string names(char quote) const;
};

/// What with_found_media() gave for a preset of `folder`, without its content where that lies
/// outside; and that content.
struct CheckedPreset {
    Preset preset;
    std::optional<OutsideContent> outside = std::nullopt;
};

/// As with_found_media and with_found_files, and separates content that lies outside.
CheckedPreset with_checked_media(const Preset& preset, const Look& look,
                                 const std::filesystem::path& folder, const RecentMedia& recent);
