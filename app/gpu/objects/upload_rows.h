#pragma once

#include "model/look/extent.h"

#include <epoxy/gl.h>

#include <span>

namespace gpu {

/// Fills rows of a face of the bound texture with RGBA floats, from row `first` on; `band` is the
/// texture's width and the number of rows. Some rows at a time: other contexts that share textures
/// wait for each call. What is kept in bytes goes as bytes, which Mesa copies many times as fast as
/// it rounds.
void upload_rows(GLenum face, int first, Extent band, bool are_bytes,
                 std::span<const float> texels);

}  // namespace gpu
