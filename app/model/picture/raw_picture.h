#pragma once

#include "model/look/picture.h"

#include <cstdint>
#include <variant>
#include <vector>

/// A picture as read from a target, for another thread. Bytes (255 is 1) and half floats are not
/// converted, and row 0 is the bottom row.
struct RawPicture {
    using Bytes = std::vector<std::uint8_t>;
    using Halves = std::vector<std::uint16_t>;
    using Floats = std::vector<float>;

    Extent extent;
    int channels = 4;  // as in Picture
    Encoding encoding = Encoding::linear;
    std::variant<Bytes, Halves, Floats> pixels;

    std::size_t row_length() const {
        return static_cast<std::size_t>(extent.width) * static_cast<std::size_t>(channels);
    }
};

/// The value of a channel; half floats are in IEEE 754 binary16.
float number_of(std::uint8_t byte);
float number_of(std::uint16_t half);
inline float number_of(float number) {
    return number;
}

/// The same pixels as floats, row 0 at the top.
Picture picture_of(const RawPicture& raw);
/// The same pixels, as floats.
RawPicture raw_of(const Picture& picture);
