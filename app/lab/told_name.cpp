#include "lab/told_name.h"

std::string told_name(const std::filesystem::path& file) {
    const std::string name = file.filename().string();
    const std::string folder = file.parent_path().filename().string();
    return name == "look.json" && !folder.empty() ? folder + "/" + name : name;
}
