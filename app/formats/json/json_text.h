#pragma once

#include <nlohmann/json_fwd.hpp>

#include <string>

/// Readable JSON text: one key per line, lists of scalars on one line, numbers in their shortest
/// exact form. Ends with a line end.
std::string json_text(const nlohmann::ordered_json& document);

/// Like json_text(), for a value at nesting level `depth` of another document. Without a line end.
std::string indented_json_text(const nlohmann::ordered_json& value, int depth);

/// On one line, with spaces.
std::string inline_json_text(const nlohmann::ordered_json& value);

/// The document with each non-integer number shortened to the fewest digits that give the same
/// 32-bit float.
nlohmann::ordered_json with_float_digits(nlohmann::ordered_json document);

/// Without spaces and line ends.
std::string compact_json_text(const nlohmann::ordered_json& document);
