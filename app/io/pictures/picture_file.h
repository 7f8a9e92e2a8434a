#pragma once

#include "base/diagnostic.h"
#include "model/look/picture.h"
#include "model/picture/raw_picture.h"

#include <filesystem>
#include <string>
#include <string_view>

/// A picture as stored: 1, 3 or 4 channels (grey with alpha becomes RGBA), alpha unassociated,
/// turned upright as its file says. Whole-number files (PNG, JPEG) are display-encoded, float files
/// (EXR, HDR) linear. Of an EXR it is the display window. A JPEG that breaks off is read to its
/// end, with a note. At most 16384 px a side and 64 Mi pixels.
Result<Picture> load_picture(const std::filesystem::path& file);

struct SaveOptions {
    bool half = false;  // .exr: 16-bit floats instead of 32-bit ones
};

/// By extension: `.png` is 8-bit RGB as encode_png says; `.exr` holds the stored values, alpha
/// associated. The same pixels give the same bytes; atomic.
Result<void> save_picture(const Picture& picture, const std::filesystem::path& file,
                          const SaveOptions& options = {});

/// The bytes of such a file, `extension` being ".png" or ".exr"; an EXR's floats are those that the
/// picture has. Errors carry no file.
Result<std::string> encode_picture(const RawPicture& picture, std::string_view extension);
