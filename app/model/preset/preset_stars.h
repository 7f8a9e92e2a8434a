#pragma once

#include <set>
#include <string>

/// The user's starred presets, as named by favourite_key(). A user setting, not part of presets.
using FavouritePresets = std::set<std::string>;

/// "phosphor/amber": a look's id and a preset's file name without its extension.
inline std::string favourite_key(const std::string& look, const std::string& preset) {
    return look + "/" + preset;
}
