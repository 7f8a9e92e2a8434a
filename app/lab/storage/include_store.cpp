#include "lab/storage/include_store.h"

#include "base/file.h"
#include "base/text.h"
#include "io/files/atomic_file.h"

#include <cstdlib>

namespace fs = std::filesystem;

namespace {
fs::path include_list_in(const Roots& roots) {
    return roots.state / "include-folders.txt";
}

fs::path typed_folder(std::string_view text) {
    const char* const home = std::getenv("HOME");
    const bool is_at_home = text == "~" || text.starts_with("~/");
    if (!is_at_home || !home)
        return fs::path(text);
    return fs::path(home) / fs::path(text.substr(std::min<std::size_t>(text.size(), 2)));
}
}  // namespace

std::vector<fs::path> load_include_folders(const Roots& roots) {
    const auto text = read_text(include_list_in(roots));
    std::vector<fs::path> folders;
    if (text)
        for (const std::string_view line : split_lines(*text))
            if (!trim(line).empty())
                folders.emplace_back(line);
    return folders;
}

Result<void> save_include_folders(const Roots& roots, const std::vector<fs::path>& folders) {
    std::string lines;
    for (const fs::path& folder : folders)
        lines += folder.string() + '\n';
    return write_atomically(include_list_in(roots), lines);
}

std::vector<fs::path> parse_include_folders(std::string_view text) {
    std::vector<fs::path> folders;
    for (const std::string_view part : split(text, ':'))
        if (!trim(part).empty())
            folders.push_back(fs::absolute(typed_folder(trim(part))).lexically_normal());
    return folders;
}

std::string include_folders_text(const std::vector<fs::path>& folders) {
    std::string text;
    for (const fs::path& folder : folders)
        text += (text.empty() ? "" : ":") + folder.string();
    return text;
}
