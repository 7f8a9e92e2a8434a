#pragma once

#include "base/diagnostic.h"

#include <string>
#include <string_view>
#include <vector>

/// One line of keys.json: the key of an action.
struct KeyChoice {
    std::string action;  // "play_pause"
    std::string key;     // "Ctrl+Space"; "": no key
    int line = 0;        // in the file

    bool operator==(const KeyChoice&) const = default;
};

/// Errors have file and line: invalid JSON, another format, a newer version, unknown keys of the
/// document, values that are not texts. The names and texts themselves are not checked.
Result<std::vector<KeyChoice>> parse_keys(std::string_view text, const std::filesystem::path& file);

/// The text of a keys.json with these choices.
std::string keys_to_json(const std::vector<KeyChoice>& choices);
