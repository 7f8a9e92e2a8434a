#pragma once

#include "lab/document/document.h"
#include "lab/library/library_view.h"
#include "lab/window/preset_browsing.h"
#include "model/preset/preset_stars.h"

#include <filesystem>
#include <string>
#include <vector>

/// A preset of the open look, or the look without a preset.
struct ListedPreset {
    ListedLookPreset preset;  // an empty file: the look without a preset
    bool is_open = false;
    bool is_modified = false;  // it is open, with unsaved changes
    bool has_star = false;

    bool is_plain() const { return preset.entry.file.empty(); }
};

ListedPreset as_listed(const ListedLookPreset& preset, const Document& document,
                       const FavouritePresets& stars);

/// The presets that match the filter, after the look without a preset. Each search word must occur
/// in the name, file name or description. Does not read files.
std::vector<ListedLookPreset> matching_presets(const Look& look,
                                               const std::vector<ListedLook>& looks,
                                               const FavouritePresets& stars,
                                               const PresetBrowsing& wanted);
/// The same with their state.
std::vector<ListedPreset> listed_presets(const Document& document,
                                         const std::vector<ListedLook>& looks,
                                         const FavouritePresets& stars,
                                         const PresetBrowsing& wanted);

/// Whether the document was opened from this file.
bool is_open_preset(const Document& document, const std::filesystem::path& file);
