#pragma once

#include "base/text.h"

#include <algorithm>
#include <array>
#include <filesystem>

/// Whether a file's name says that it is a sound.
inline bool is_sound_file(const std::filesystem::path& file) {
    constexpr std::array extensions{".wav", ".flac", ".ogg", ".oga", ".mp3", ".aif", ".aiff"};
    const std::string extension = to_lower(file.extension().string());
    return std::find(extensions.begin(), extensions.end(), extension) != extensions.end();
}
