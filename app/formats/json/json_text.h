#pragma once

#include <nlohmann/json_fwd.hpp>

#include <string>

/// The text of a document that people read and compare: a key a line, lists of plain values on one
/// line, numbers as short as they read back the same; ends with a line end.
std::string json_text(const nlohmann::ordered_json& document);

/// The same of a value that stands `depth` levels deep in another document; without a line end.
std::string indented_json_text(const nlohmann::ordered_json& value, int depth);

/// On one line, with blanks.
std::string inline_json_text(const nlohmann::ordered_json& value);

/// The document with each number that is not whole cut to the fewest digits that read back as the
/// same 32-bit float.
nlohmann::ordered_json with_float_digits(nlohmann::ordered_json document);

/// A document without a blank or line end.
std::string compact_json_text(const nlohmann::ordered_json& document);
