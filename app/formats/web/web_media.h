#pragma once

#include "base/diagnostic.h"
#include "formats/portable/exact_picture.h"

#include <filesystem>
#include <string>

/// A media file as the text of a JSON value: a data URL, or for a picture that browsers can't show
/// exactly (16 bits, EXR, TIFF) an object with its size, encoding and 16-bit floats (gzip, base64).
Result<std::string> web_media(const std::filesystem::path& file);
/// The same for a generated picture.
Result<std::string> web_media(const PictureFile& picture);
