#pragma once

#include "model/preset/preset.h"

#include <string>
#include <string_view>

/// The text of a preset's file, brought to `preset`: only members that changed are written anew, a
/// new one goes to its sorted place, and all else keeps its bytes. A text that cannot be read as a
/// preset is written anew as a whole. `look`: as in preset_to_json.
std::string updated_preset_text(std::string_view text, const Preset& preset, const Look* look);
