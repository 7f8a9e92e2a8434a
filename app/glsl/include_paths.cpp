#include "glsl/include_paths.h"

#include "base/text.h"
#include "glsl/shader_files.h"

#include <algorithm>

namespace fs = std::filesystem;

IncludePaths::IncludePaths(const fs::path& file, const IncludeRoots& roots, ShaderFiles& disk)
    : m_disk(disk) {
    fs::path look = roots.look_folder.empty() ? file.parent_path() : roots.look_folder;
    if (look.empty())
        look = ".";
    const fs::path beside =
        look.has_filename() ? look.parent_path() : look.parent_path().parent_path();
    m_folders = {look, (look == "." ? ".." : beside) / "include"};
    if (!roots.shared.empty())
        m_folders.push_back(roots.shared);
}

bool IncludePaths::is_allowed(const fs::path& file) const {
    return !m_disk.exists(file) || std::ranges::any_of(m_folders, [&](const fs::path& folder) {
        return m_disk.is_inside(file, folder);
    });
}

std::optional<fs::path> IncludePaths::find(std::string_view name, const fs::path& beside,
                                           std::vector<fs::path>& tried) const {
    std::vector<fs::path> folders{beside};
    folders.insert(folders.end(), m_folders.begin(), m_folders.end());
    for (const fs::path& folder : folders) {
        const fs::path candidate = (folder / name).lexically_normal();
        if (std::ranges::find(tried, candidate) == tried.end())
            tried.push_back(candidate);
        if (m_disk.exists(candidate))
            return candidate;
    }
    return std::nullopt;
}

std::string fault_of_include_name(std::string_view name) {
    if (name.empty())
        return "#include needs the name of a file";
    if (name.find('\\') != std::string_view::npos)
        return "write '/' between the folders of an include";
    if (name.front() == '/' || (name.size() > 1 && name[1] == ':'))
        return "an absolute path cannot be included";
    for (const std::string_view part : split(name, '/'))
        if (part == "..")
            return "'..' cannot be used in an include";
    return {};
}
