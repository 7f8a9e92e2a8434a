#pragma once

#include "base/diagnostic.h"

#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

/// A JSON value and its location in the text.
struct JsonValue {
    enum class Kind { null, boolean, number, text, array, object };

    Kind kind = Kind::null;
    bool boolean = false;
    double number = 0.0;  // finite
    std::string text;
    std::vector<JsonValue> children;  // elements or members in text order
    std::string key;                  // for members
    int line = 1;                     // first line of the value; for a member, of its key
    std::size_t key_begin = 0;        // bytes [key_begin, end): a member with its key
    std::size_t begin = 0;            // bytes [begin, end): the value
    std::size_t end = 0;

    bool is(Kind asked) const { return kind == asked; }
};

/// Duplicate keys of an object: an error, or the last one counts.
enum class DuplicateKeys { refused, last_wins };

/// Parses a complete JSON text of at most 16 MiB, 128 levels and a million values. Errors have
/// `file` and the line.
Result<JsonValue> parse_json(std::string_view text, const std::filesystem::path& file,
                             DuplicateKeys duplicate_keys = DuplicateKeys::refused);

/// " (column 12)" for a location in a text whose values are on one line, where a line number is not
/// enough; otherwise "".
std::string column_note(std::string_view text, std::size_t at);

/// The member of an object, or null.
const JsonValue* find_member(const JsonValue& object, std::string_view key);

/// The lines of the members of `key` in a file, by name; empty if it is not valid JSON.
std::map<std::string, int> member_lines(const std::filesystem::path& file, std::string_view key);

/// A value as shown in messages: "5", "'amber'", "[...]".
std::string shown_json(const JsonValue& value);
