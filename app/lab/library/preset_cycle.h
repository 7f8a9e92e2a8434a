#pragma once

#include "lab/library/library.h"
#include "model/preset/preset_stars.h"

/// A position in a look's list of presets. The first is the look without a preset.
struct PresetIndex {
    std::filesystem::path file;  // "": no preset
    std::size_t number = 0;      // of the preset, from 1; 0: no preset
    std::size_t count = 0;       // number of presets

    bool operator==(const PresetIndex&) const = default;
};

/// The preset `by` positions after `open` (negative: before), with wrap-around. A preset that is
/// not in the list counts as the look without a preset.
PresetIndex preset_after(const std::vector<PresetEntry>& presets, const std::filesystem::path& open,
                         int by);

/// The same among starred presets only; number and count are of those. `open` need not be starred.
/// nullopt: no preset is starred.
std::optional<PresetIndex> favourite_after(const std::vector<PresetEntry>& presets,
                                           const FavouritePresets& stars,
                                           const std::filesystem::path& open, int by);
