#pragma once

#include "base/diagnostic.h"

#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

/// A value of a JSON text, and where in the text it stands.
struct JsonValue {
    enum class Kind { null, boolean, number, text, array, object };

    Kind kind = Kind::null;
    bool boolean = false;
    double number = 0.0;  // finite
    std::string text;
    std::vector<JsonValue> children;  // elements or members, in the order of the text
    std::string key;                  // of a member
    int line = 1;                     // where the value, for a member its key, begins
    std::size_t key_begin = 0;        // bytes [key_begin, end) are a member with its key,
    std::size_t begin = 0;            // [begin, end) the value
    std::size_t end = 0;

    bool is(Kind asked) const { return kind == asked; }
};

/// What is done about a key that an object has twice: it is a mistake, or the last one counts.
enum class DoubleKeys { refused, last_counts };

/// Reads a whole JSON text: at most 16 MiB, 128 levels deep, a million values. Errors have `file`
/// and the line.
Result<JsonValue> parse_json(std::string_view text, const std::filesystem::path& file,
                             DoubleKeys double_keys = DoubleKeys::refused);

/// " (column 12)" of a place in a text whose values stand in one line, which a line alone does not
/// tell; else "".
std::string column_note(std::string_view text, std::size_t at);

/// The member of an object, or null.
const JsonValue* find_member(const JsonValue& object, std::string_view key);

/// The lines of a file's members below the member `key`, by name; none where it is no JSON.
std::map<std::string, int> lines_below(const std::filesystem::path& file, std::string_view key);

/// A value as messages show it: "5", "'amber'", "[...]".
std::string shown_json(const JsonValue& value);
