#pragma once

#include "formats/json/object_reader.h"
#include "model/preset/preset.h"

#include <nlohmann/json_fwd.hpp>

#include <filesystem>

/// Reads the member "modulation" of a preset: parameter names, each with an object of a kind and
/// its numbers. Reports unknown keys and numbers beyond their limits, with lines.
Modulations read_modulations(ObjectReader& reader);

/// JSON that read_modulations() reads as the same modulations.
nlohmann::ordered_json json_of(const Modulation& modulation);
nlohmann::ordered_json json_of(const Modulations& modulations);

/// Reads the member "tempo" of a preset; the default tempo without one. Reports unknown keys and
/// numbers beyond their limits, with lines.
Tempo read_tempo(ObjectReader& reader);
/// JSON that read_tempo() reads as the same tempo.
nlohmann::ordered_json json_of(const Tempo& tempo);

/// The preset's modulations under the current parameter names (`@was`); orphans are kept. Error: a
/// modulation of a parameter that cannot be modulated, at its line of `file` if that is the
/// preset's JSON.
Result<Modulations> fitted_modulations(const Look& look, const Preset& preset,
                                       const std::filesystem::path& file);
