#pragma once

#include "lab/messages/choice.h"
#include "lab/window/preset_list.h"

/// What can be done with the presets of the open look beside opening them.
std::vector<ChoiceList> preset_choices(const std::vector<ListedPreset>& presets,
                                       const PresetBrowsing& wanted);

/// What can be done in a source checkout alone.
ChoiceList shipped_preset_choices();

/// Seconds that a morph may take.
inline constexpr std::array morph_lengths{1.0, 3.0, 10.0, 30.0, 60.0};
