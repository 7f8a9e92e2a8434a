#pragma once

#include "base/diagnostic.h"

#include <filesystem>
#include <string>
#include <vector>

/// A look that new looks are copied from. It is in `shaders/templates/` of the program's root.
struct LookTemplate {
    std::string id;  // folder name
    std::string name;
    std::string about;
    std::filesystem::path folder;
};

/// The shipped templates: a picture filter, a beam look and a generator. An unreadable one is left
/// out.
std::vector<LookTemplate> look_templates(const std::filesystem::path& root);

/// The file in a look's folder that lists show as its picture. Copies of a look don't get it.
inline constexpr const char* picture_name = "look.png";

/// Copies the template's files into an existing, empty folder, with another name in look.json.
Result<void> copy_template(const LookTemplate& look, const std::filesystem::path& folder,
                           const std::string& name);
