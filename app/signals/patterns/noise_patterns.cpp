#include "signals/patterns/noise_patterns.h"

#include "signals/patterns/hash.h"
#include "signals/patterns/tiled_noise.h"

#include <array>
#include <cmath>

namespace {
std::uint32_t number(int n) {
    return static_cast<std::uint32_t>(n);
}

template <class Texel>
Picture pattern_of_texels(Extent extent, int channels, Texel texel) {
    Picture picture{extent, channels, Encoding::display, {}};
    for (int y = 0; y < extent.height; ++y)
        for (int x = 0; x < extent.width; ++x)
            for (int channel = 0; channel < channels; ++channel)
                picture.pixels.push_back(texel(x, y, channel));
    return picture;
}

// Quantised like an 8-bit file.
float in_bytes(double share) {
    return static_cast<float>(std::floor(share * 256.0) / 255.0);
}

Picture draw_noise(Extent extent, double) {
    return pattern_of_texels(extent, 4, [](int x, int y, int channel) {
        return in_bytes(hash_to_unit(number(x), number(y), number(channel)));
    });
}

Picture draw_grey_noise(Extent extent, double) {
    return pattern_of_texels(extent, 3, [](int x, int y, int) {
        return in_bytes(hash_to_unit(number(x), number(y), 4));
    });
}

// Two fractal noise fields; one distorts the other.
Picture draw_stone(Extent extent, double) {
    constexpr std::array<std::array<double, 3>, 2> colors{{{0.20, 0.17, 0.15}, {0.82, 0.72, 0.58}}};
    Picture picture{extent, 3, Encoding::display, {}};
    for (int y = 0; y < extent.height; ++y)
        for (int x = 0; x < extent.width; ++x) {
            const double u = (x + 0.5) / extent.width;
            const double v = (y + 0.5) / extent.height;
            constexpr double bend = 0.15;
            const double bent = bend * tiled_fractal_noise({u, v, 0.0}, 4, 1);
            const double share = tiled_fractal_noise({u + bent, v - bent, 0.5}, 4, 2);
            for (std::size_t channel = 0; channel < 3; ++channel)
                picture.pixels.push_back(
                    static_cast<float>(std::lerp(colors[0][channel], colors[1][channel], share)));
        }
    return picture;
}

// The matrix of order 8 (B. E. Bayer, 1973): the bits of x ^ y and y, interleaved, lowest bit
// first.
int bayer_rank(int x, int y) {
    int rank = 0;
    for (int bit = 0; bit < 3; ++bit)
        rank = rank * 4 + (((x ^ y) >> bit & 1) << 1 | (y >> bit & 1));
    return rank;
}

Picture draw_bayer(Extent extent, double) {
    return pattern_of_texels(extent, 3, [](int x, int y, int) {
        return static_cast<float>(bayer_rank(x % 8, y % 8) * 4 / 255.0);
    });
}
}  // namespace

std::vector<Pattern> noise_patterns() {
    return {
        {{"noise", "Noise", "Random values, independent in red, green, blue and alpha."},
         {256, 256},
         draw_noise},
        {{"grey-noise", "Grey noise", "Random values, the same in all channels."},
         {256, 256},
         draw_grey_noise},
        {{"stone", "Stone", "Fractal noise in the colours of sandstone. It tiles seamlessly."},
         {512, 512},
         draw_stone},
        {{"bayer", "Bayer matrix", "8 x 8 thresholds for ordered dithering."}, {8, 8}, draw_bayer}};
}
