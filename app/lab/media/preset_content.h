#pragma once

#include "lab/storage/media.h"
#include "model/preset/preset.h"

#include <optional>
#include <string>

/// Content of a preset that requires the user's consent, because presets can come from other
/// people. This is a file outside the preset's folder that is not among the recent files, or a
/// socket outside the runtime folder.
struct OutsideContent {
    std::string name = {};                      // file or socket of signal or source; "": allowed
    std::optional<Spec> signal = std::nullopt;  // the removed signal
    std::string source = {};                    // the removed source
    Values files = {};                          // of parameters

    std::size_t count() const { return files.size() + (name.empty() ? 0 : 1); }
    /// For the window: the content that was not loaded.
    std::string notice() const;
    /// For the command line: includes the options that allow it.
    std::string refusal() const;
    /// "file '/tmp/a.png', 2 more".
    std::string names(char quote) const;
};

/// The result of with_found_media() for a preset in `folder`, without its outside content; and that
/// content.
struct CheckedPreset {
    Preset preset;
    std::optional<OutsideContent> outside = std::nullopt;
};

/// As with_found_media() and with_found_files(), and separates outside content.
CheckedPreset with_checked_media(const Preset& preset, const Look& look,
                                 const std::filesystem::path& folder, const RecentMedia& recent);
