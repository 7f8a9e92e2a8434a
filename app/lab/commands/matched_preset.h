#pragma once

#include "lab/commands/preset_commands.h"
#include "lab/match/photo_matcher.h"

/// Puts the found values into the document, and saves it as a new preset with an unused name. The
/// photo and the camera are saved next to it.
void save_matched_preset(const PhotoMatcher& matcher, Document& document, PresetCommands& presets,
                         Messages& messages);
