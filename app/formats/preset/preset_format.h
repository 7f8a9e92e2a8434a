#pragma once

#include "base/diagnostic.h"
#include "model/preset/preset.h"

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <string>
#include <string_view>

/// The maximum size of an unpacked preset, in bytes.
constexpr std::size_t largest_preset = std::size_t{4} << 20;

/// Parses a preset's JSON. Errors, with lines: unknown keys, unknown kinds and settings of signals,
/// a newer format version. Values are only checked to be numbers, lists of numbers or texts.
Result<Preset> parse_preset(std::string_view text, const std::filesystem::path& file);

/// Loads a preset from a JSON file, a PNG that contains one, or a text file with a share line.
Result<Preset> load_preset(const std::filesystem::path& file);

/// The text of a preset file, one key per line. With `look`, its switches (bool) are written as
/// true and false, otherwise as 1 and 0; both read the same.
std::string preset_to_json(const Preset& preset, const Look* look = nullptr);

/// Precision of numbers: 32-bit float, or exact double.
enum class Digits { of_float, all };

/// The document written by preset_to_json().
nlohmann::ordered_json preset_json(const Preset& preset, const Look* look = nullptr,
                                   Digits digits = Digits::of_float);

/// Writes the file atomically. Updates an existing preset and keeps the bytes of unchanged members.
Result<void> save_preset(const std::filesystem::path& file, const Preset& preset,
                         const Look* look = nullptr);

/// Whether both presets give the same file for that look.
bool is_written_alike(const Preset& one, const Preset& other, const Look& look);

/// The preset with the look's defaults for missing values, as for sharing.
Preset with_all_values(Preset preset, const Look& look);

/// The preset's values converted for the look's parameters: previous names (@was) replaced, numbers
/// clamped, texts parsed like user input ("#ff8000", an item's label). Orphans are kept. Values
/// that do not fit are errors at their line of `file`, if that is the preset's JSON.
Result<Values> fitted_values(const Look& look, const Preset& preset,
                             const std::filesystem::path& file);
