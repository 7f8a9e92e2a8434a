#pragma once

#include "base/diagnostic.h"

#include <filesystem>
#include <optional>
#include <string_view>
#include <vector>

/// The folders that hold `shaders/` and `presets/`: the program's root, then the person's own.
struct Roots {
    std::filesystem::path program;
    std::filesystem::path user;        // $XDG_DATA_HOME/afterglow; need not exist
    std::filesystem::path state;       // $XDG_STATE_HOME/afterglow; need not exist
    std::filesystem::path cache = {};  // $XDG_CACHE_HOME/afterglow; need not exist

    std::vector<std::filesystem::path> all() const { return {program, user}; }
    std::filesystem::path shared_includes() const { return program / "shaders" / "include"; }
};

/// `data` (from --data), $AFTERGLOW_DATA, a folder above the program that holds shaders/ (or its
/// share/afterglow), the source tree: the first that holds `shaders/`.
Result<Roots> find_roots(const std::optional<std::filesystem::path>& data);
