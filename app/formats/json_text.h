#pragma once

#include <nlohmann/json_fwd.hpp>

#include <string>

/// The text of a document that people read and compare: a key a line, lists of plain values on one
/// line, numbers as short as they read back the same; ends with a line end.
std::string json_text(const nlohmann::ordered_json& document);

/// The same without a blank or line end.
std::string compact_json_text(const nlohmann::ordered_json& document);
