#pragma once

#include "model/look/picture.h"

/// The floats of an 8-bit value.
float float_of(std::uint8_t byte);

/// A picture with bytes as RGB floats; another one unchanged.
Picture with_floats(const Picture& picture);

/// The first of the 4 bytes of a pixel of a picture with bytes.
inline const std::uint8_t* bytes_at(const Picture& picture, int x, int y) {
    return picture.bytes.get() + picture.index(x, y);
}
