#pragma once

#include "formats/slang/files.h"

#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

/// One `key = value` of a .slangp file.
struct SlangSetting {
    std::string key;
    std::string value;  // without its quotes; UTF-8
    Location declared;
};

/// What a .slangp file says, without the files that it refers to.
struct SlangSettings {
    std::filesystem::path file;
    std::vector<SlangSetting> settings;    // in order, each key once: the first one counts
    std::vector<SlangSetting> references;  // of #reference lines, in order; the key is empty
    std::unordered_map<std::string, std::size_t> places;  // of keys in `settings`

    /// nullptr: the file does not say.
    const SlangSetting* find(const std::string& key) const;
};

/// Reads a file's lines. `key = value`, in quotes or up to the next blank; what follows on the line
/// is a comment, and so is what follows '#' outside of quotes and a line that begins with "//".
/// `#include "file"` stands for that file's lines. A value that is in force already and differs
/// is a warning, and so is a line that is none of these (but not within "/* */"). Errors: a file
/// that cannot be read, includes in a circle, more than 16 deep or
/// more than 256, more than 256 references, paths of more than 4096 bytes, more than `files`
/// counts.
Result<SlangSettings> read_slang_settings(const std::filesystem::path& file, SlangFiles& files,
                                          Diagnostics& warnings);

/// Yes and no as a person writes them: true, false, 1, 0, also with a ';' behind. Anything else is
/// a warning and nothing.
std::optional<bool> read_slang_boolean(const SlangSetting& setting, Diagnostics& warnings);

/// The number that the value begins with; 0 and a warning where it begins with none.
double read_slang_number(const SlangSetting& setting, Diagnostics& warnings);
