#pragma once

#include "formats/json/object_reader.h"
#include "model/look/parameter.h"

#include <nlohmann/json_fwd.hpp>

#include <optional>

/// Reads a number, a boolean, a list of up to 16 of them, or a text (a path). nullopt, with an
/// error, for other values.
std::optional<Value> read_value(const JsonValue& value, ObjectReader& reader);

/// JSON that read_value() reads as the same value. Switch parameters are written as true and false.
nlohmann::ordered_json json_of(const Value& value, const Parameter* parameter = nullptr);
