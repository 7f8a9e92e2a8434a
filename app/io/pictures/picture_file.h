#pragma once

#include "base/diagnostic.h"
#include "model/look/picture.h"
#include "model/picture/raw_picture.h"

#include <filesystem>
#include <string>
#include <string_view>

/// A picture as stored: 1, 3 or 4 channels (grey with alpha becomes RGBA), alpha unassociated,
/// rotated by the file's orientation. Integer files (PNG, JPEG) are display-encoded, float files
/// (EXR, HDR) linear. An EXR gives its display window. A truncated JPEG is read as far as possible,
/// with a note. At most 16384 px a side and 64 Mi pixels.
Result<Picture> load_picture(const std::filesystem::path& file);

struct SaveOptions {
    bool half = false;  // .exr: 16-bit instead of 32-bit floats
};

/// By extension: `.png` is 8-bit RGB of encode_png; `.exr` has the stored values, alpha associated.
/// The same pixels give the same bytes; the write is atomic.
Result<void> save_picture(const Picture& picture, const std::filesystem::path& file,
                          const SaveOptions& options = {});

/// The bytes of such a file; `extension` is ".png" or ".exr". An EXR keeps the float type of the
/// picture. Errors have no file.
Result<std::string> encode_picture(const RawPicture& picture, std::string_view extension);
