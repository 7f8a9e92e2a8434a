#pragma once

#include "gpu/objects/texture.h"
#include "model/look/picture.h"

#include <vector>

namespace gpu {

/// Converts a picture for Texture::upload: RGBA, its colours (not alpha) in the `wanted` encoding,
/// its rows in the wanted order. `texels` is reused, so that a video does not allocate per frame.
void fill_texels(const Picture& picture, Encoding wanted, std::vector<float>& texels,
                 RowOrder rows = RowOrder::bottom_first);

/// Fills a flat texture of the picture's size, band by band, so that a large picture is not stored
/// twice. `band` is reused.
void upload_picture(Texture& texture, const Picture& picture, Encoding wanted,
                    std::vector<float>& band, RowOrder rows = RowOrder::bottom_first);

/// A new texture with the picture in the `wanted` encoding.
Result<Texture> texture_of(const Picture& picture, Format format, Encoding wanted);

}  // namespace gpu
