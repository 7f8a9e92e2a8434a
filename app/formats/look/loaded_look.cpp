#include "formats/look/loaded_look.h"

#include "base/text.h"

namespace fs = std::filesystem;

std::string foreign_look_id(const fs::path& file) {
    return with_each(with_each(file.filename().string(), "+", "%2B"), "#", "%23");
}

std::string foreign_file_name(std::string_view id) {
    return with_each(with_each(id, "%2B", "+"), "%23", "#");
}
