#include "gpu/headless.h"
#include "gpu/objects/texels.h"

#include <algorithm>

namespace {
// Values from 0 to 1, alpha included; all neighbours differ.
Picture uneven(Extent extent) {
    Picture picture{extent, 4, Encoding::linear, {}};
    for (int i = 0; i < extent.width * extent.height * 4; ++i)
        picture.pixels.push_back(static_cast<float>(i * 37 % 61) / 60.0f);
    return picture;
}

gpu::Texture mip_texture_of(const Picture& picture, Format format) {
    auto texture = gpu::Texture::make(picture.extent, format, true);
    REQUIRE(texture.has_value());
    std::vector<float> texels;
    gpu::fill_texels(picture, picture.encoding, texels);
    texture->upload(texels);
    return std::move(*texture);
}

gpu::Texture cube_of(int side) {
    auto cube = gpu::Texture::make_solid(PictureShape::cube, side, Format::rgba32f, true);
    REQUIRE(cube.has_value());
    cube->upload(uneven({side, side * 6}).pixels);
    return std::move(*cube);
}

// RGBA of one level of a flat texture or a cube face, as stored: sRGB is not decoded.
std::vector<float> level_of(const gpu::Texture& texture, GLenum face, int level) {
    std::vector<float> texels(std::size_t(std::max(1, texture.extent().width >> level)) *
                              std::size_t(std::max(1, texture.extent().height >> level)) * 4);
    glBindTexture(texture.target(), texture.id());
    glGetTexImage(face, level, GL_RGBA, GL_FLOAT, texels.data());
    glBindTexture(texture.target(), 0);
    return texels;
}

// The largest difference between two textures of one kind in their smaller levels.
float difference(const gpu::Texture& one, const gpu::Texture& other, GLenum face) {
    float maximum = 0;
    for (int level = 1; level < one.levels(); ++level) {
        const std::vector<float> a = level_of(one, face, level);
        const std::vector<float> b = level_of(other, face, level);
        for (std::size_t i = 0; i < a.size(); ++i)
            maximum = std::max(maximum, std::abs(a[i] - b[i]));
    }
    return maximum;
}

void let_the_driver_make_levels(const gpu::Texture& texture) {
    glBindTexture(texture.target(), texture.id());
    glGenerateMipmap(texture.target());
    glBindTexture(texture.target(), 0);
}

constexpr float one_code = 1.01f / 255;
}  // namespace

TEST_CASE_FIXTURE(Headless, "a mipmap texel is the mean of four texels of the previous level") {
    const Picture picture = uneven({8, 4});
    gpu::Texture texture = mip_texture_of(picture, Format::rgba32f);
    const std::vector<float> whole = level_of(texture, GL_TEXTURE_2D, 0);
    texture.generate_mipmaps();
    const std::vector<float> half = level_of(texture, GL_TEXTURE_2D, 1);
    const auto at = [&whole](int x, int y, std::size_t c) {
        return whole[std::size_t(y * 8 + x) * 4 + c];
    };
    for (int y = 0; y < 2; ++y)
        for (int x = 0; x < 4; ++x)
            for (std::size_t c = 0; c < 4; ++c) {
                const float mean = (at(2 * x, 2 * y, c) + at(2 * x + 1, 2 * y, c) +
                                    at(2 * x, 2 * y + 1, c) + at(2 * x + 1, 2 * y + 1, c)) /
                                   4;
                CHECK(half[std::size_t(y * 4 + x) * 4 + c] == doctest::Approx(mean).epsilon(1e-4));
            }
}

TEST_CASE_FIXTURE(Headless, "sRGB mipmaps average light, not codes") {
    const Picture black_and_white{{2, 1}, 4, Encoding::linear, {0, 0, 0, 1, 1, 1, 1, 1}};
    gpu::Texture texture = mip_texture_of(black_and_white, Format::srgb8_alpha8);
    texture.generate_mipmaps();
    // IEC 61966-2-1: half the light is code 188 of 255.
    CHECK(level_of(texture, GL_TEXTURE_2D, 1)[0] == doctest::Approx(188.0 / 255).epsilon(0.004));
}

// For odd sides, drivers choose their own filter. Mesa's is linear, like ours.
TEST_CASE_FIXTURE(Headless, "mipmaps match the driver's own at any size") {
    const bool is_mesa = (*context)->info().renderer.starts_with("llvmpipe");
    for (const FormatInfo& info : all_formats())
        for (const Extent extent : {Extent{16, 16}, Extent{37, 21}, Extent{1, 7}, Extent{5, 2}}) {
            if (info.is_integer || (extent.width != extent.height && !is_mesa))
                continue;
            CAPTURE(info.name);
            CAPTURE(extent.width);
            gpu::Texture ours = mip_texture_of(uneven(extent), info.format);
            const gpu::Texture theirs = mip_texture_of(uneven(extent), info.format);
            ours.generate_mipmaps();
            let_the_driver_make_levels(theirs);
            CHECK(difference(ours, theirs, GL_TEXTURE_2D) <= one_code);
        }
}

TEST_CASE_FIXTURE(Headless, "each face of a cube has its own mipmaps") {
    gpu::Texture ours = cube_of(8);
    const gpu::Texture theirs = cube_of(8);
    ours.generate_mipmaps();
    let_the_driver_make_levels(theirs);
    for (GLenum face = 0; face < 6; ++face) {
        CAPTURE(face);
        CHECK(difference(ours, theirs, GL_TEXTURE_CUBE_MAP_POSITIVE_X + face) <= one_code);
    }
}

TEST_CASE_FIXTURE(Headless, "a scissor rectangle does not affect mipmaps") {
    gpu::Texture texture = mip_texture_of(uneven({8, 8}), Format::rgba32f);
    gpu::Texture limited = mip_texture_of(uneven({8, 8}), Format::rgba32f);
    texture.generate_mipmaps();
    glEnable(GL_SCISSOR_TEST);
    glScissor(0, 0, 1, 1);
    limited.generate_mipmaps();
    CHECK(glIsEnabled(GL_SCISSOR_TEST) == GL_TRUE);
    glDisable(GL_SCISSOR_TEST);
    CHECK(difference(texture, limited, GL_TEXTURE_2D) == 0);
}
