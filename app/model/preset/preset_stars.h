#pragma once

#include <set>
#include <string>

/// The user's starred presets, as named by star_of(). A user setting, not part of presets.
using PresetStars = std::set<std::string>;

/// "phosphor/amber": a look's id and a preset's file name without its extension.
inline std::string star_of(const std::string& look, const std::string& preset) {
    return look + "/" + preset;
}
