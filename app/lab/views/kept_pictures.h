#pragma once

#include "gpu/objects/texture.h"
#include "lab/views/views.h"

#include <filesystem>
#include <map>
#include <optional>

/// The small pictures of kept sessions as textures, each read from its file when it is first shown.
class KeptPictures {
public:
    /// Row 0 at the bottom; without a handle where there is none.
    Views::Image of(const std::filesystem::path& file) const;

private:
    mutable std::map<std::filesystem::path, std::optional<gpu::Texture>> m_textures;
};
