#pragma once

#include "formats/json/object_reader.h"
#include "model/preset/preset.h"

#include <nlohmann/json_fwd.hpp>

#include <filesystem>

/// Reads the member "modulation" of a preset: parameter names, each with an object of a kind and
/// its figures. Unknown keys and numbers beyond their limits are noted at their lines.
Modulations read_modulations(ObjectReader& reader);

/// What read_modulations reads as the same ones.
nlohmann::ordered_json json_of(const Modulation& modulation);
nlohmann::ordered_json json_of(const Modulations& modulations);

/// The preset's modulations under the names that parameters have now (`@was`); orphans stay. One of
/// a parameter that cannot move is an error at its line of `file`, where that is the preset's JSON.
Result<Modulations> fitted_modulations(const Look& look, const Preset& preset,
                                       const std::filesystem::path& file);
