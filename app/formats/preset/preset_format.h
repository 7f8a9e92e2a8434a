#pragma once

#include "base/diagnostic.h"
#include "model/preset/preset.h"

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <string>
#include <string_view>

/// The longest text, in bytes, that is unpacked as a preset.
constexpr std::size_t largest_preset = std::size_t{4} << 20;

/// Reads a preset's JSON. Unknown keys, and kinds and settings of signals that there are not, are
/// errors with their line; the values are only checked to be numbers, lists of numbers or texts.
/// A newer version of the format is refused.
Result<Preset> parse_preset(std::string_view text, const std::filesystem::path& file);

/// Reads a preset from a JSON file, a PNG that holds one, or a text file that holds a share line.
Result<Preset> load_preset(const std::filesystem::path& file);

/// The preset as a file: keys sorted, one a line. With the look at hand its switches (bool) are
/// written as true and false, else as 1 and 0; both read the same.
std::string preset_to_json(const Preset& preset, const Look* look = nullptr);

/// How numbers are written: as 32-bit floats, or so that they read back as they are.
enum class Digits { of_float, all };

/// The document that preset_to_json writes.
nlohmann::ordered_json preset_json(const Preset& preset, const Look* look = nullptr,
                                   Digits digits = Digits::of_float);

/// Writes the file in one step; a crash leaves the old or the new one. A preset that is there keeps
/// all bytes that say the same.
Result<void> save_preset(const std::filesystem::path& file, const Preset& preset,
                         const Look* look = nullptr);

/// Whether the files of both would say the same of that look.
bool is_written_alike(const Preset& one, const Preset& other, const Look& look);

/// The preset with the look's defaults where it says nothing: what a shared preset holds.
Preset with_all_values(Preset preset, const Look& look);

/// The preset's values as the look's parameters take them: former names (@was) moved to the new
/// ones, numbers clamped, texts read as a person would type them ("#ff8000", an item's label).
/// Orphans stay. What does not fit is an error at its line of `file`, where that is the preset's
/// JSON.
Result<Values> fitted_values(const Look& look, const Preset& preset,
                             const std::filesystem::path& file);
