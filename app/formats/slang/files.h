#pragma once

#include "base/diagnostic.h"
#include "formats/slang/directives.h"
#include "formats/slang/parameters.h"

#include <filesystem>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <vector>

/// A text of a slang shader or preset with its directives.
struct SlangText {
    std::filesystem::path file;  // as first requested
    std::filesystem::path real;  // with links resolved; equal paths are one file
    std::string text;            // every line ends with '\n'
    int line_count = 0;
    std::vector<SlangDirective> directives;
    SlangParameters parameters;  // one per directive; null for other directives and parse errors
};

/// The texts of presets and shaders, each read once. Use one object per load of a preset with all
/// its shaders, because it never reads a file again.
class SlangFiles {
public:
    /// A text of at most 4 MiB, valid as long as this object. Errors apply to the whole file.
    Result<const SlangText*> read(const std::filesystem::path& file);

    /// Counts the size of a text before each read of its settings. The error if the total exceeds 8
    /// MiB, otherwise "".
    std::string count_settings(const SlangText& text);

    /// Records a relevant file that is not read here: a missing file, a picture.
    void note(const std::filesystem::path& file);

    /// Every file read or missing, in order, each once. For a watcher; valid after a failure, too.
    const std::vector<std::filesystem::path>& seen() const { return m_seen; }

private:
    Result<const SlangText*> read_anew(const std::filesystem::path& file);

    std::map<std::filesystem::path::string_type, Result<const SlangText*>> m_by_name;
    std::map<std::filesystem::path::string_type, std::unique_ptr<const SlangText>> m_by_real_name;
    std::vector<std::filesystem::path> m_seen;
    std::set<std::filesystem::path::string_type> m_noted;
    std::size_t m_settings_bytes = 0;
};

/// Whether a file is a shader and not a preset, by its name.
bool is_slang_shader(const std::filesystem::path& file);

/// The path `written` in `file`, with '/' or '\' as separator: relative to the folder of `file`,
/// with `..` resolved.
std::filesystem::path sibling_path(const std::filesystem::path& file, std::string_view written);
