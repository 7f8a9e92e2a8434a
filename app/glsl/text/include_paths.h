#pragma once

#include "glsl/text/include.h"

#include <optional>
#include <string_view>

/// Where includes may be found. A path lies in a folder by its name alone: a link counts where it
/// stands, wherever it leads to.
class IncludePaths {
public:
    IncludePaths(const std::filesystem::path& file, const IncludeRoots& roots, ShaderFiles& disk);

    /// What became of the search for an include.
    struct Found {
        std::optional<std::filesystem::path> file;  // nothing: there is none that may be read
        std::vector<std::filesystem::path> tried;   // in order, the file among them
        bool leads_out = false;                     // the place beside the file may not be read
    };
    /// The first file called `name` as seen from a file in `beside`.
    Found find(std::string_view name, const std::filesystem::path& beside) const;

    /// " (did you mean 'Noise.glsl'?)" for a file whose name is nearly that of one of `tried`; else
    /// "".
    static std::string nearest_name(const std::vector<std::filesystem::path>& tried);

    /// The folder that was opened.
    const std::filesystem::path& tree() const { return m_tree; }

private:
    bool is_readable(const std::filesystem::path& file) const;

    ShaderFiles& m_disk;
    std::vector<std::filesystem::path> m_folders;  // that are searched
    std::filesystem::path m_tree;
};

/// Why nothing may be included under this name; "" when it may.
std::string fault_of_include_name(std::string_view name);

/// Whether a file may be included, by its extension.
bool is_include_text(const std::filesystem::path& file);
