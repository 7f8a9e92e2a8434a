#include "formats/look/loaded_look.h"

#include "base/text.h"

namespace fs = std::filesystem;

std::string foreign_look_id(const fs::path& file) {
    return replace_all(replace_all(file.filename().string(), "+", "%2B"), "#", "%23");
}

std::string foreign_file_name(std::string_view id) {
    return replace_all(replace_all(id, "%2B", "+"), "%23", "#");
}
