#pragma once

#include "model/preset/preset.h"

#include <string>
#include <string_view>

/// Updates the text of a preset file to `preset`. Only changed members are rewritten, new ones are
/// inserted in order, and other bytes are kept. A text that is not a valid preset is rewritten
/// completely. `look`: see preset_to_json().
std::string updated_preset_text(std::string_view text, const Preset& preset, const Look* look);
