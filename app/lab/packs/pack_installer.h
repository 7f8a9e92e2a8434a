#pragma once

#include "base/diagnostic.h"
#include "lab/library/library.h"

#include <filesystem>
#include <string>
#include <vector>

/// What became of a look or preset of a pack.
struct InstalledItem {
    enum class Status {
        added,
        renamed,  // added under a free name, because the user has another one of this name
        present,  // the user has it already
    };

    std::string name;  // for display
    std::string id;    // of the look, or "look/preset"
    Status status = Status::added;

    bool operator==(const InstalledItem&) const = default;
};

struct InstalledPack {
    std::string name;
    std::vector<InstalledItem> looks;
    std::vector<InstalledItem> presets;
};

/// Adds the looks and presets of a pack to the user's folder. Never overwrites a file, and writes
/// nowhere else. Nothing of it is compiled or drawn. On an error, nothing is added.
Result<InstalledPack> install_pack(const std::filesystem::path& pack, const Library& library);

/// "Installed 'Night': 1 look and 3 presets. You already had 1 preset."
std::string summary(const InstalledPack& installed);
