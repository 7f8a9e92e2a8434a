#include "gpu/objects/upload_rows.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace gpu {

namespace {
// The nearest 8-bit code; 0 for NaN.
std::uint8_t code_of(float number) {
    return static_cast<std::uint8_t>(number > 0 ? std::min(number, 1.0f) * 255.0f + 0.5f : 0.0f);
}
}  // namespace

void upload_rows(GLenum face, int first, Extent extent, bool are_bytes,
                 std::span<const float> texels) {
    constexpr int texels_at_once = 1 << 16;
    const int max_rows = std::max(1, texels_at_once / extent.width);
    std::vector<std::uint8_t> codes;
    for (int row = 0; row < extent.height; row += max_rows) {
        const int rows = std::min(max_rows, extent.height - row);
        const auto width = static_cast<std::size_t>(extent.width) * 4;
        const std::span<const float> band = texels.subspan(width * static_cast<std::size_t>(row),
                                                           width * static_cast<std::size_t>(rows));
        if (are_bytes) {
            codes.resize(band.size());
            std::ranges::transform(band, codes.begin(), code_of);
            glTexSubImage2D(face, 0, 0, first + row, extent.width, rows, GL_RGBA, GL_UNSIGNED_BYTE,
                            codes.data());
        } else {
            glTexSubImage2D(face, 0, 0, first + row, extent.width, rows, GL_RGBA, GL_FLOAT,
                            band.data());
        }
    }
}

}  // namespace gpu
