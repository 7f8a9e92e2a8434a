#pragma once

#include "base/diagnostic.h"
#include "model/picture.h"

#include <string>

/// The bytes of an 8-bit RGB PNG marked as sRGB: display values as they are, linear ones clamped
/// and sRGB-encoded (IEC 61966-2-1), NaN black. The same pixels give the same bytes; errors carry
/// no file.
Result<std::string> encode_png(const Picture& picture);
