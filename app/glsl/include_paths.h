#pragma once

#include "glsl/include.h"

#include <optional>
#include <string_view>

/// Where includes may be found.
class IncludePaths {
public:
    IncludePaths(const std::filesystem::path& file, const IncludeRoots& roots, ShaderFiles& disk);

    /// Whether a file lies in one of the folders after links are followed; true for what is
    /// missing.
    bool is_allowed(const std::filesystem::path& file) const;

    /// The first file called `name` as seen from a file in `beside`; every path that was looked at
    /// goes to `tried`. Nothing when there is none.
    std::optional<std::filesystem::path> find(std::string_view name,
                                              const std::filesystem::path& beside,
                                              std::vector<std::filesystem::path>& tried) const;

private:
    ShaderFiles& m_disk;
    std::vector<std::filesystem::path> m_folders;
};

/// Why nothing may be included under this name; "" when it may.
std::string fault_of_include_name(std::string_view name);
