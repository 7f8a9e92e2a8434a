#pragma once

#include "model/look/picture.h"

#include <cstdint>
#include <variant>
#include <vector>

/// A picture as it is read of a target, for another thread to go on with: bytes (255 for 1) and
/// half floats stay such, and row 0 is the bottom one.
struct RawPicture {
    using Bytes = std::vector<std::uint8_t>;
    using Halves = std::vector<std::uint16_t>;
    using Floats = std::vector<float>;

    Extent extent;
    int channels = 4;  // as a Picture's
    Encoding encoding = Encoding::linear;
    std::variant<Bytes, Halves, Floats> pixels;

    std::size_t row_length() const {
        return static_cast<std::size_t>(extent.width) * static_cast<std::size_t>(channels);
    }
};

/// The number that a channel stands for: bits of a half float are those of IEEE 754 binary16.
float number_of(std::uint8_t byte);
float number_of(std::uint16_t half);
inline float number_of(float number) {
    return number;
}

/// The same pixels as floats, row 0 on top.
Picture picture_of(const RawPicture& raw);
