#include "glsl/text/include_paths.h"

#include "base/text.h"
#include "glsl/text/shader_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace fs = std::filesystem;

namespace {
constexpr std::array include_endings{".glsl", ".frag", ".vert", ".fs",
                                     ".vs",   ".h",    ".inc",  ".slang"};

fs::path absolute_path(const fs::path& path) {
    std::error_code error;
    return fs::absolute(path, error).lexically_normal();
}

bool is_below(const fs::path& path, const fs::path& folder) {
    const auto [end, _] = std::mismatch(folder.begin(), folder.end(), path.begin(), path.end());
    return end == folder.end() || (end->empty() && std::next(end) == folder.end());
}
}  // namespace

fs::path opened_tree(const fs::path& file) {
    const fs::path folder = absolute_path(file).parent_path();
    std::error_code error;
    for (fs::path above = folder; !above.empty(); above = above.parent_path()) {
        if (fs::exists(above / ".git", error) || fs::exists(above / "look.json", error))
            return above;
        if (above == above.parent_path())
            break;
    }
    return folder.parent_path();
}

IncludePaths::IncludePaths(const fs::path& file, const IncludeRoots& roots, ShaderFiles& disk)
    : m_disk(disk), m_tree(roots.tree.empty() ? opened_tree(file) : absolute_path(roots.tree)) {
    fs::path look = roots.look_folder.empty() ? file.parent_path() : roots.look_folder;
    if (look.empty())
        look = ".";
    const fs::path parent =
        look.has_filename() ? look.parent_path() : look.parent_path().parent_path();
    m_folders = {look, (look == "." ? ".." : parent) / "include"};
    if (!roots.folders.shared.empty())
        m_folders.push_back(roots.folders.shared);
    m_folders.insert(m_folders.end(), roots.folders.named.begin(), roots.folders.named.end());
}

bool IncludePaths::is_readable(const fs::path& file) const {
    const fs::path absolute = absolute_path(file);
    return is_below(absolute, m_tree) ||
           std::ranges::any_of(m_folders, [&](const fs::path& folder) {
               return is_below(absolute, absolute_path(folder));
           });
}

IncludePaths::Found IncludePaths::find(std::string_view name,
                                       const fs::path& including_folder) const {
    std::vector<fs::path> folders{including_folder};
    folders.insert(folders.end(), m_folders.begin(), m_folders.end());
    Found found;
    for (const fs::path& folder : folders) {
        const fs::path candidate = (folder / name).lexically_normal();
        if (std::ranges::find(found.tried, candidate) != found.tried.end())
            continue;
        if (!is_readable(candidate)) {
            found.escapes_root = found.escapes_root || folder == including_folder;
            continue;
        }
        found.tried.push_back(candidate);
        if (m_disk.exists(candidate)) {
            found.file = candidate;
            break;
        }
    }
    return found;
}

std::string IncludePaths::nearest_name(const std::vector<fs::path>& tried) {
    constexpr int max_names = 1000;
    for (const fs::path& file : tried) {
        const std::string wanted = to_lower(file.filename().string());
        std::error_code error;
        int names = 0;
        for (fs::directory_iterator entry(file.has_parent_path() ? file.parent_path() : ".", error);
             entry != fs::directory_iterator() && ++names < max_names; entry.increment(error))
            if (to_lower(entry->path().filename().string()) == wanted)
                return fmt::format(" (did you mean '{}'?)", entry->path().filename().string());
    }
    return {};
}

std::string fault_of_include_name(std::string_view name) {
    if (name.empty())
        return "#include needs a file name";
    if (name.find('\\') != std::string_view::npos)
        return "use '/' instead of '\\' in an include";
    if (name.front() == '/' || (name.size() > 1 && name[1] == ':'))
        return "can't include an absolute path. Add its folder with --include FOLDER (in the "
               "window: "
               "Edit > Includes) and write the rest of the path here.";
    if (!is_include_text(name))
        return fmt::format("can't include '{}': use a file that ends in {}", name,
                           fmt::join(include_endings, ", "));
    return {};
}

bool is_include_text(const fs::path& file) {
    return std::ranges::find(include_endings, to_lower(file.extension().string())) !=
           include_endings.end();
}
