#pragma once

#include "lab/document/document.h"
#include "lab/library/shelf.h"
#include "lab/window/window_state.h"
#include "model/preset/preset_stars.h"

#include <filesystem>
#include <string>
#include <vector>

/// A preset of the open look, or the look as it is without one.
struct ListedPreset {
    ShelfPreset preset;  // with an empty file: the look as it is
    bool is_open = false;
    bool is_modified = false;  // it is open, and something was turned since
    bool has_star = false;

    bool is_plain() const { return preset.entry.file.empty(); }
};

ListedPreset as_listed(const ShelfPreset& preset, const Document& document,
                       const PresetStars& stars);

/// Those that the person wants to see, by name; the look as it is goes first. Words are sought in
/// name, file and about, each of them somewhere.
std::vector<ListedPreset> listed_presets(const Document& document,
                                         const std::vector<ShelfLook>& looks,
                                         const PresetStars& stars, const PresetBrowsing& wanted);

/// Whether the document came from that file.
bool is_open_preset(const Document& document, const std::filesystem::path& file);
