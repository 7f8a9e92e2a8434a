#pragma once

#include "formats/json/object_reader.h"
#include "model/look/spec.h"

#include <nlohmann/json_fwd.hpp>

#include <optional>

/// Reads `{"kind": "lissajous", "x": 3}`; kind and settings are checked, and kept as they are
/// written. Nothing where a mistake was noted.
std::optional<Spec> read_spec(const JsonValue& value, const std::filesystem::path& file,
                              Diagnostics& problems);

/// What read_spec reads as the same signal; a bare first setting goes under its own key.
nlohmann::ordered_json json_of(const Spec& spec);
