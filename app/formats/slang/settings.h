#pragma once

#include "formats/slang/files.h"

#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

/// A `key = value` of a .slangp file.
struct SlangSetting {
    std::string key;
    std::string value;  // without quotes; UTF-8
    Location declared;
};

/// The content of a .slangp file, without the files that it references.
struct SlangSettings {
    std::filesystem::path file;
    std::vector<SlangSetting> settings;    // in order, each key once; the first one counts
    std::vector<SlangSetting> references;  // of #reference lines, in order; the key is empty
    std::unordered_map<std::string, std::size_t> indices;  // index in `settings` by key

    /// Null if the file does not contain the key.
    const SlangSetting* find(const std::string& key) const;
};

/// Reads the lines of a file: `key = value`, in quotes or up to the next space. The rest of the
/// line is a comment, and so is text after '#' outside quotes and a line that starts with "//".
/// `#include "file"` is replaced by that file's lines. Warnings: a different value for a key that
/// is already set, and other lines (except within "/* */"). Errors: a file that cannot be read;
/// circular includes, more than 16 levels or more than 256; more than 256 references; paths longer
/// than 4096 bytes; more bytes than `files` allows.
Result<SlangSettings> read_slang_settings(const std::filesystem::path& file, SlangFiles& files,
                                          Diagnostics& warnings);

/// Parses true, false, 1 or 0, optionally followed by ';'. nullopt with a warning for other values.
std::optional<bool> read_slang_boolean(const SlangSetting& setting, Diagnostics& warnings);

/// The number at the start of the value; 0 with a warning if there is none.
double read_slang_number(const SlangSetting& setting, Diagnostics& warnings);
