#pragma once

#include "lab/views/view_image.h"

#include <filesystem>
#include <map>
#include <optional>

/// The thumbnails of stored sessions as textures. Each file is read when first displayed.
class StashThumbnails {
public:
    /// Row 0 at the bottom; a handle of 0: no picture.
    ViewImage of(const std::filesystem::path& file) const;

private:
    mutable std::map<std::filesystem::path, std::optional<gpu::Texture>> m_textures;
};
