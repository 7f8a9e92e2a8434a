#include "lab/storage/display_name.h"

#include <fmt/format.h>

#include <cstdlib>
#include <string_view>

std::string display_name(const std::filesystem::path& file) {
    const std::string name = file.filename().string();
    const std::string folder = file.parent_path().filename().string();
    return name == "look.json" && !folder.empty() ? folder + "/" + name : name;
}

std::string saved_text(const std::string& name) {
    return fmt::format("Saved \"{}\"", name);
}

std::string display_folder(const std::filesystem::path& folder) {
    const char* home = std::getenv("HOME");
    std::string name = folder.string();
    if (!home || *home == '\0' || !name.starts_with(std::string(home) + '/'))
        return name;
    return '~' + name.substr(std::string_view(home).size());
}
