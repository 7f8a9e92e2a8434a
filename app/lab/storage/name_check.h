#pragma once

#include <span>
#include <string>
#include <string_view>

/// Whether a typed name can be used.
struct NameCheck {
    bool is_valid = false;
    std::string problem = {};     // what to change; "" for a valid or an empty name
    std::string suggestion = {};  // a valid name like it; "": none

    bool operator==(const NameCheck&) const = default;
};

/// The name of a preset. It is valid on every file system: letters of all languages, digits, spaces
/// and -_.()+, at most 100 bytes, without a dot at the start and without spaces at the ends.
NameCheck check_preset_name(std::string_view name);

/// The folder name of a new look: lowercase letters, digits, - and _, starting with a letter or
/// digit, at most 100 bytes.
NameCheck check_look_id(std::string_view id);

/// The rule for the names of files that a command writes.
struct FileNameRule {
    std::span<const std::string> extensions = {};  // ".png"; the first is added if there is none
    std::string_view content = "Files";            // what is saved: "Pictures"
};

/// The name of a file to write, without folders: one of the extensions or none, at most 255 bytes
/// with it.
NameCheck check_file_name(std::string_view name, const FileNameRule& rule);

/// The name with the first extension of the rule if it has none.
std::string with_extension(std::string_view name, const FileNameRule& rule);

/// A valid preset name like any text; "": nothing is left of it.
std::string valid_preset_name(std::string_view text);

/// A valid look id like any text: "My Look" becomes "my-look"; "": nothing is left of it.
std::string valid_look_id(std::string_view text);
