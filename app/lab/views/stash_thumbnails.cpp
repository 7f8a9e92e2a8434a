#include "lab/views/stash_thumbnails.h"

#include "gpu/objects/texels.h"
#include "io/pictures/picture_file.h"

ViewImage StashThumbnails::of(const std::filesystem::path& file) const {
    const auto known = m_textures.find(file);
    if (known == m_textures.end()) {
        std::optional<gpu::Texture>& texture = m_textures[file];
        std::error_code error;
        if (!std::filesystem::exists(file, error))
            return {};
        if (const auto picture = load_picture(file))
            if (auto made = gpu::texture_of(*picture, Format::rgba8, Encoding::display))
                texture.emplace(std::move(*made));
        return of(file);
    }
    return image_of(known->second ? &*known->second : nullptr);
}
