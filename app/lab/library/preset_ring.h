#pragma once

#include "lab/library/library.h"
#include "model/preset/preset_stars.h"

/// A place in a look's list of presets. The first is the look as it is, without one.
struct PresetPlace {
    std::filesystem::path file;  // "": as the look has it
    std::size_t number = 0;      // of the preset, from 1; 0: as the look has it
    std::size_t count = 0;       // of the presets

    bool operator==(const PresetPlace&) const = default;
};

/// The place `by` on (or, below 0, back) from the preset `open`, round and round; a preset that is
/// not in the list counts as the look as it is.
PresetPlace preset_beside(const std::vector<PresetEntry>& presets,
                          const std::filesystem::path& open, int by);

/// The same among those with a star alone, where number and count are of those; the one that is
/// open need not have one. None where no preset has one.
std::optional<PresetPlace> starred_beside(const std::vector<PresetEntry>& presets,
                                          const PresetStars& stars,
                                          const std::filesystem::path& open, int by);
