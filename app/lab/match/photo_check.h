#pragma once

#include "base/diagnostic.h"
#include "model/look/picture.h"
#include "model/photo/camera.h"

#include <filesystem>

/// A photo of a tube: display values with at least three channels, turned as its orientation says.
/// Fails for files that can't be read, pictures without colours, linear light, and photos that need
/// more than a quarter of the machine's memory.
Result<Picture> load_photo(const std::filesystem::path& file);

/// Fails for corners that can't be right, and if the screen is overexposed.
Result<void> check_photo(const Picture& photo, const Corners& corners,
                         const std::filesystem::path& file);

/// The size of a screen in a photo, px: the lengths of its sides, with the nearest usual aspect
/// ratio, at most 1280 px wide.
Extent screen_size(const Corners& corners);
