#pragma once

#include "glsl/text/include.h"

#include <optional>
#include <string_view>

/// Finds include files in the permitted folders. A path is checked by name only: a link counts by
/// its own path, wherever it points.
class IncludePaths {
public:
    IncludePaths(const std::filesystem::path& file, const IncludeRoots& roots, ShaderFiles& disk);

    /// The result of an include search.
    struct Found {
        std::optional<std::filesystem::path> file;  // nullopt: no readable file found
        std::vector<std::filesystem::path> tried;   // in order, including the file found
        bool escapes_root = false;                  // the path in the including folder is not
                                                    // permitted
    };
    /// The first file called `name`, as included by a file in the folder `including_folder`.
    Found find(std::string_view name, const std::filesystem::path& including_folder) const;

    /// " (did you mean 'Noise.glsl'?)" for a file whose name differs from one of `tried` only in
    /// case; otherwise "".
    static std::string nearest_name(const std::vector<std::filesystem::path>& tried);

    /// The folder opened by the user.
    const std::filesystem::path& tree() const { return m_tree; }

private:
    bool is_readable(const std::filesystem::path& file) const;

    ShaderFiles& m_disk;
    std::vector<std::filesystem::path> m_folders;  // searched in order
    std::filesystem::path m_tree;
};

/// Why this include name is invalid; "" when it is valid.
std::string fault_of_include_name(std::string_view name);

/// Whether the file extension allows an include.
bool is_include_text(const std::filesystem::path& file);
