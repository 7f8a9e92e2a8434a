#pragma once

#include <set>
#include <string>

/// The presets that a person has starred, each as star_of() names it; theirs, and in no preset.
using PresetStars = std::set<std::string>;

/// "phosphor/amber": of a look's id and a preset's file without its ending.
inline std::string star_of(const std::string& look, const std::string& preset) {
    return look + "/" + preset;
}
