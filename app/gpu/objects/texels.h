#pragma once

#include "gpu/objects/texture.h"
#include "model/look/picture.h"

#include <vector>

namespace gpu {

/// A picture as Texture::upload takes it: RGBA, its colours (not alpha) taken to the `wanted`
/// encoding, its rows in the wanted order. `texels` is used again, so that a video makes no new
/// memory a frame.
void fill_texels(const Picture& picture, Encoding wanted, std::vector<float>& texels,
                 RowOrder rows = RowOrder::bottom_first);

/// Fills a flat texture of the picture's size, band by band, so that a large picture is not held
/// twice. `band` is used again.
void upload_picture(Texture& texture, const Picture& picture, Encoding wanted,
                    std::vector<float>& band, RowOrder rows = RowOrder::bottom_first);

/// A texture that holds a picture in the `wanted` encoding.
Result<Texture> texture_of(const Picture& picture, Format format, Encoding wanted);

}  // namespace gpu
