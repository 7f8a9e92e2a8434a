#pragma once

#include "formats/json/object_reader.h"
#include "model/look/parameter.h"

#include <nlohmann/json_fwd.hpp>

#include <optional>

/// Reads a number, true or false, a list of up to 16 of them, or a text (a path). Nothing, and
/// noted, where it is none of them.
std::optional<Value> read_value(const JsonValue& value, ObjectReader& reader);

/// What read_value reads as the same value: for a parameter that is a switch true and false.
nlohmann::ordered_json json_of(const Value& value, const Parameter* parameter = nullptr);
