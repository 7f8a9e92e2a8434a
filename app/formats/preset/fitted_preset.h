#pragma once

#include "base/diagnostic.h"
#include "model/look/look.h"
#include "model/preset/preset.h"

#include <filesystem>

/// The preset with values and modulations for this look: list items found by label, names renamed
/// as `@was` requests, see fitted_values() and fitted_modulations(). If some do not fit, they stay
/// as they are and `warnings` has the reason, with the preset's file.
Preset fitted_preset(const Look& look, Preset preset, const std::filesystem::path& file,
                     Diagnostics& warnings);
