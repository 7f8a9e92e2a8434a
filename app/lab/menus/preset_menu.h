#pragma once

#include "lab/messages/menu_entry.h"
#include "lab/window/preset_list.h"

/// The commands for presets of the open look, except opening them.
std::vector<MenuSection> preset_sections(const std::vector<ListedPreset>& presets,
                                         const PresetBrowsing& wanted);

/// The commands that need a source checkout.
MenuSection shipped_preset_section();

/// Durations of a morph in seconds.
inline constexpr std::array morph_lengths{1.0, 3.0, 10.0, 30.0, 60.0};
