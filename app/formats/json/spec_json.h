#pragma once

#include "formats/json/object_reader.h"
#include "model/look/spec.h"

#include <nlohmann/json_fwd.hpp>

#include <optional>

/// Reads `{"kind": "lissajous", "x": 3}`. Checks kind and settings, and keeps them as written.
/// nullopt if an error was reported.
std::optional<Spec> read_spec(const JsonValue& value, const std::filesystem::path& file,
                              Diagnostics& problems);

/// JSON that read_spec() reads as the same signal. A bare first setting gets its own key.
nlohmann::ordered_json json_of(const Spec& spec);
