#include "formats/portable/exact_picture.h"

#include "io/pictures/picture_codec.h"
#include "io/pictures/png_encoder.h"
#include "model/picture/display_bytes.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace {
bool has_only_bytes(const Picture& picture) {
    constexpr float tolerance = 1e-4f;  // of a step
    return std::ranges::all_of(picture.pixels, [](float value) {
        const float steps = value * 255.0f;
        return value >= 0.0f && value <= 1.0f && std::abs(steps - std::round(steps)) < tolerance;
    });
}

// RGBA, 65535 is 1.
std::vector<std::uint16_t> words_of(const Picture& picture) {
    std::vector<std::uint16_t> words;
    const auto channels = static_cast<std::size_t>(picture.channels);
    const std::size_t green = channels < 3 ? 0 : 1;
    const auto word = [](float value) {
        return static_cast<std::uint16_t>(std::lround(std::clamp(value, 0.0f, 1.0f) * 65535.0f));
    };
    for (std::size_t at = 0; at + channels <= picture.pixels.size(); at += channels) {
        const float* const pixel = &picture.pixels[at];
        words.insert(words.end(), {word(pixel[0]), word(pixel[green]), word(pixel[2 * green]),
                                   word(channels == 4 ? pixel[3] : 1.0f)});
    }
    return words;
}
}  // namespace

Result<PictureFile> exact_picture_file(const Picture& picture) {
    if (picture.encoding == Encoding::linear) {
        const auto codec = picture_codec();
        if (!codec)
            return fail(codec.error());
        auto bytes = (*codec)->encode_exr(picture, true);
        return bytes ? Result<PictureFile>(PictureFile{".exr", std::move(*bytes), picture})
                     : fail(bytes.error());
    }
    const bool has_alpha = is_transparent(picture);
    auto bytes =
        !has_only_bytes(picture) ? encode_png_16(picture.extent, words_of(picture), has_alpha)
        : has_alpha ? encode_png_with_alpha(picture.extent, display_bytes_with_alpha(picture))
                    : encode_png(picture);
    if (!bytes)
        return fail(bytes.error());
    return PictureFile{".png", std::move(*bytes), picture};
}
