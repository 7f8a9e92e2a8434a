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

/// A text of a slang tree with what it asks of the reader.
struct SlangText {
    std::filesystem::path file;  // as it was first asked for
    std::filesystem::path real;  // after links; two texts with the same one are one file
    std::string text;            // every line ends with '\n'
    int line_count = 0;
    std::vector<SlangDirective> directives;
    SlangParameters parameters;  // one a directive; none where it is another or cannot be read
};

/// The texts of presets and shaders, each read once however many passes and includes ask for it.
/// One object is for one reading of a preset with all its shaders: it never looks at a file again.
class SlangFiles {
public:
    /// A text of at most 4 MiB; valid as long as this object. The errors are about the whole file.
    Result<const SlangText*> read(const std::filesystem::path& file);

    /// Counts a text whose settings are about to be read, as often as it is. What is wrong where
    /// they are more than 8 MiB in all, else "".
    std::string count_settings(const SlangText& text);

    /// Notes a file that matters though it was not read here: one that is missing, a picture.
    void note(const std::filesystem::path& file);

    /// Every file that was read, or looked for and missing, in that order, each once: for a
    /// watcher, also after a failure.
    const std::vector<std::filesystem::path>& seen() const { return m_seen; }

private:
    Result<const SlangText*> read_anew(const std::filesystem::path& file);

    std::map<std::filesystem::path::string_type, Result<const SlangText*>> m_by_name;
    std::map<std::filesystem::path::string_type, std::unique_ptr<const SlangText>> m_by_real_name;
    std::vector<std::filesystem::path> m_seen;
    std::set<std::filesystem::path::string_type> m_noted;
    std::size_t m_settings_bytes = 0;
};

/// Whether a file is a shader, and no preset, by its name.
bool is_slang_shader(const std::filesystem::path& file);

/// The path that stands in `file` as `written`, with '/' or '\' between its parts: relative to the
/// folder of `file`, with `..` resolved.
std::filesystem::path path_beside(const std::filesystem::path& file, std::string_view written);
