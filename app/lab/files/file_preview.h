#pragma once

#include "model/look/picture.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

/// What the file dialog shows of a file before it is opened.
struct FilePreview {
    std::optional<Picture> picture = {};  // small, display-encoded
    std::vector<std::string> lines = {};  // "1280 × 720", or "0:13", "44.1 kHz stereo"
};

/// The longest side of the picture of a preview, in pixels.
inline constexpr int preview_side = 384;

/// Whether a preview of a file with this name can be shown: a picture or a sound.
bool has_preview(const std::filesystem::path& file);

/// Reads a picture or the header of a sound. Other files, and pictures of more than 64 MB, have no
/// preview.
FilePreview load_preview(const std::filesystem::path& file);
