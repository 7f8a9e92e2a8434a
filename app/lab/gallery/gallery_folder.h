#pragma once

#include "base/diagnostic.h"

#include <filesystem>

inline constexpr const char* gallery_index = "index.html";
inline constexpr const char* gallery_thumbnails = "thumbnails";
inline constexpr const char* gallery_pages = "pages";

/// Whether a new gallery may replace what is at this path: nothing, an empty folder, or an earlier
/// gallery without other files.
Result<void> check_gallery_folder(const std::filesystem::path& folder);
