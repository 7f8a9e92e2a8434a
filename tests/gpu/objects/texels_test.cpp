#include "gpu/objects/texels.h"

#include "model/look/color.h"
#include "model/picture/byte_pixels.h"

#include <doctest/doctest.h>

TEST_CASE("grey and RGB become RGBA, with the bottom row first") {
    std::vector<float> texels;
    gpu::fill_texels({{1, 2}, 1, Encoding::linear, {0.25f, 0.75f}}, Encoding::linear, texels);
    CHECK(texels == std::vector<float>{0.75f, 0.75f, 0.75f, 1, 0.25f, 0.25f, 0.25f, 1});
    gpu::fill_texels({{1, 1}, 3, Encoding::linear, {1, 2, 3}}, Encoding::linear, texels);
    CHECK(texels == std::vector<float>{1, 2, 3, 1});
}

TEST_CASE("colours are converted between encodings to 1e-6, and alpha is unchanged") {
    std::vector<float> texels;
    for (int i = 0; i <= 1000; ++i) {
        const float x = static_cast<float>(i) / 1000.0f;
        gpu::fill_texels({{1, 1}, 4, Encoding::display, {x, x, x, x}}, Encoding::linear, texels);
        CHECK(texels[0] == doctest::Approx(srgb_decode(x)).epsilon(1e-6));
        CHECK(texels[3] == x);
        gpu::fill_texels({{1, 1}, 4, Encoding::linear, {x, x, x, x}}, Encoding::display, texels);
        CHECK(texels[0] == doctest::Approx(srgb_encode(x)).epsilon(1e-6));
    }
}

TEST_CASE("light beyond 0..1 follows the curve, mirrored below zero") {
    std::vector<float> texels;
    gpu::fill_texels({{1, 1}, 3, Encoding::display, {2.0f, -0.5f, 1.0f}}, Encoding::linear, texels);
    CHECK(texels[0] == doctest::Approx(srgb_decode(2.0)).epsilon(1e-6));
    CHECK(texels[1] == doctest::Approx(-srgb_decode(0.5)).epsilon(1e-6));
}

TEST_CASE("bytes are uploaded like their floats") {
    Picture bytes{{3, 2}, 4, Encoding::display, {}};
    const auto values = std::make_shared<std::vector<std::uint8_t>>(24);
    for (std::size_t i = 0; i < values->size(); ++i)
        (*values)[i] = static_cast<std::uint8_t>(i * 11);
    bytes.bytes = {values, values->data()};
    for (const Encoding wanted : {Encoding::display, Encoding::linear})
        for (const RowOrder rows : {RowOrder::bottom_first, RowOrder::top_first}) {
            std::vector<float> from_bytes;
            std::vector<float> from_floats;
            gpu::fill_texels(bytes, wanted, from_bytes, rows);
            gpu::fill_texels(with_floats(bytes), wanted, from_floats, rows);
            CHECK(from_bytes == from_floats);
            CHECK(from_bytes[3] == 1.0f);
        }
}
