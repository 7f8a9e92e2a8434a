#pragma once

#include "model/look/extent.h"

#include <epoxy/gl.h>

#include <span>

namespace gpu {

/// Uploads RGBA floats to rows of a face of the bound texture, starting at row `first`. `band` is
/// the texture's width and the number of rows. Uploads a few rows at a time, because other contexts
/// that share textures wait for each call. Byte formats are uploaded as bytes, which Mesa copies
/// many times faster than it rounds floats.
void upload_rows(GLenum face, int first, Extent band, bool are_bytes,
                 std::span<const float> texels);

}  // namespace gpu
