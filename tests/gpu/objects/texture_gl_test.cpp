#include "gpu/headless.h"
#include "gpu/objects/canvas.h"
#include "gpu/objects/readback.h"
#include "gpu/objects/texels.h"

namespace {
gpu::Texture texture_of(const Picture& picture, Format format, bool is_mipmapped = false) {
    auto texture = gpu::Texture::make(picture.extent, format, is_mipmapped);
    REQUIRE(texture.has_value());
    std::vector<float> texels;
    gpu::fill_texels(picture, picture.encoding, texels);
    texture->upload(texels);
    texture->generate_mipmaps();
    return std::move(*texture);
}

// 0 and 1: values that every format can store.
Picture corners() {
    return {{2, 2}, 4, Encoding::linear, {1, 0, 0, 1, 0, 1, 0, 1, 0, 0, 1, 1, 1, 1, 1, 1}};
}
}  // namespace

TEST_CASE_FIXTURE(Headless, "a picture is read back as uploaded, with row 0 at the top") {
    CHECK(gpu::read_picture(texture_of(corners(), Format::rgba32f)) == corners());
}

TEST_CASE_FIXTURE(
    Headless, "uploading a large picture in bands gives the same texture as uploading it whole") {
    Picture picture{{1200, 1801}, 3, Encoding::display, {}};
    for (std::size_t i = 0; i < picture.index(0, 1801); ++i)
        picture.pixels.push_back(static_cast<float>(i * 37 % 61) / 60.0f);
    for (const Format format : {Format::rgba32f, Format::rgba8})
        for (const RowOrder rows : {RowOrder::bottom_first, RowOrder::top_first}) {
            auto whole = gpu::Texture::make(picture.extent, format, false);
            auto banded = gpu::Texture::make(picture.extent, format, false);
            REQUIRE((whole && banded));
            std::vector<float> texels;
            gpu::fill_texels(picture, Encoding::linear, texels, rows);
            whole->upload(texels);
            gpu::upload_picture(*banded, picture, Encoding::linear, texels, rows);
            CHECK(texels.size() < picture.pixels.size());
            CHECK((gpu::read_picture(*banded) == gpu::read_picture(*whole)));
        }
}

TEST_CASE_FIXTURE(
    Headless, "a raw picture read for another thread is the same picture, and reuses its memory") {
    Picture picture{{5, 3}, 4, Encoding::linear, {}};
    for (int i = 0; i < 5 * 3 * 4; ++i)
        picture.pixels.push_back(static_cast<float>(i * 37 % 61) / 60.0f);
    RawPicture raw;
    for (int turn = 0; turn < 2; ++turn)
        for (const FormatInfo& info : all_formats()) {
            CAPTURE(info.name);
            if (info.is_integer)
                continue;
            const gpu::Texture texture = texture_of(picture, info.format);
            gpu::read_raw(texture, raw);
            CHECK(picture_of(raw) == gpu::read_picture(texture));
        }
    gpu::read_raw(texture_of(picture, Format::rgba16f), raw);
    CHECK(std::holds_alternative<RawPicture::Halves>(raw.pixels));
    gpu::read_raw(texture_of(picture, Format::rgba8), raw);
    CHECK(std::holds_alternative<RawPicture::Bytes>(raw.pixels));
}

TEST_CASE_FIXTURE(Headless, "a picture with many rows is read back whole in every format") {
    Picture tall{{300, 700}, 4, Encoding::linear, {}};
    for (int i = 0; i < 300 * 700 * 4; ++i)
        tall.pixels.push_back(static_cast<float>(i * 37 % 256) / 255.0f);
    CHECK(gpu::read_picture(texture_of(tall, Format::rgba32f)) == tall);
    const Picture codes = gpu::read_picture(texture_of(tall, Format::rgba8));
    REQUIRE(codes.pixels.size() == tall.pixels.size());
    for (std::size_t i = 0; i < tall.pixels.size(); ++i)
        REQUIRE(std::abs(codes.pixels[i] - tall.pixels[i]) < 1e-6f);
}

TEST_CASE_FIXTURE(Headless, "8-bit formats round to the nearest code, and NaN is black") {
    const float none = std::numeric_limits<float>::quiet_NaN();
    const Picture odd{
        {2, 1}, 4, Encoding::linear, {-3, 1.4f / 255, 1.6f / 255, 1, none, 7, 0.5f, 1}};
    const gpu::Texture texture = texture_of(odd, Format::rgba8);
    CHECK(gpu::read_pixel(texture, 0, 0) == std::array{0.0f, 1 / 255.0f, 2 / 255.0f, 1.0f});
    const auto second = gpu::read_pixel(texture, 1, 0);
    CHECK(second[0] == 0.0f);
    CHECK(second[1] == 1.0f);
    CHECK(std::abs(second[2] - 0.5f) <= 0.51f / 255);
}

TEST_CASE_FIXTURE(Headless, "every format returns the channels that it has") {
    for (const FormatInfo& info : all_formats()) {
        if (info.is_integer)
            continue;
        CAPTURE(info.name);
        const Picture back = gpu::read_picture(texture_of(corners(), info.format));
        const Picture whole = corners();
        REQUIRE(back.channels == (info.channels == 2 ? 3 : info.channels));
        for (int y = 0; y < 2; ++y)
            for (int x = 0; x < 2; ++x)
                for (int c = 0; c < back.channels; ++c) {
                    const float wanted =
                        c < info.channels ? whole.pixels[whole.index(x, y) + std::size_t(c)] : 0;
                    CHECK(back.pixels[back.index(x, y) + std::size_t(c)] == wanted);
                }
    }
}

TEST_CASE_FIXTURE(Headless,
                  "a single pixel is read at its position, with missing channels filled in") {
    const gpu::Texture texture = texture_of(corners(), Format::rgba16f);
    CHECK(gpu::read_pixel(texture, 1, 0) == std::array<float, 4>{0, 1, 0, 1});
    CHECK(gpu::read_pixel(texture, 0, 1) == std::array<float, 4>{0, 0, 1, 1});
    const gpu::Texture red = texture_of(corners(), Format::r16f);
    CHECK(gpu::read_pixel(red, 0, 0) == std::array<float, 4>{1, 0, 0, 1});
}

TEST_CASE_FIXTURE(Headless, "every format can be drawn into, and starts as zero") {
    for (const FormatInfo& info : all_formats()) {
        CAPTURE(info.name);
        auto canvas = gpu::Canvas::make({3, 5}, info.format);
        REQUIRE(canvas.has_value());
        for (const float number : gpu::read_picture(canvas->texture()).pixels)
            CHECK(number == 0.0f);
    }
}

TEST_CASE_FIXTURE(Headless, "a canvas is cleared to a colour and copied") {
    auto one = gpu::Canvas::make({4, 2}, Format::rgba16f);
    auto two = gpu::Canvas::make({4, 2}, Format::rgba16f);
    REQUIRE((one && two));
    one->clear({0.5f, 2.0f, 0.0f, 1.0f});
    one->copy_to(*two);
    CHECK(gpu::read_pixel(two->texture(), 3, 1) == std::array<float, 4>{0.5f, 2.0f, 0.0f, 1.0f});
    auto whole = gpu::Canvas::make({1, 1}, Format::r32ui);
    REQUIRE(whole.has_value());
    whole->clear({70000.0f, 0, 0, 0});
    CHECK(gpu::read_pixel(whole->texture(), 0, 0)[0] == 70000.0f);
    whole->clear({-5.0f, 0, 0, 0});
    CHECK(gpu::read_pixel(whole->texture(), 0, 0)[0] == 0.0f);
}

TEST_CASE_FIXTURE(Headless, "integers of every integer format are read back per channel") {
    constexpr std::array<float, 4> from_zero{200.0f, 100.0f, 50.0f, 3.0f};
    constexpr std::array<float, 4> of_either_sign{-128.0f, 127.0f, -5.0f, -1.0f};
    for (const FormatInfo& info : all_formats()) {
        if (!info.is_integer)
            continue;
        CAPTURE(info.name);
        auto whole = gpu::Canvas::make({2, 1}, info.format);
        REQUIRE(whole.has_value());
        const auto& numbers = info.is_signed ? of_either_sign : from_zero;
        whole->clear(numbers);
        const auto pixel = gpu::read_pixel(whole->texture(), 1, 0);
        const Picture picture = gpu::read_picture(whole->texture());
        for (int channel = 0; channel < info.channels; ++channel) {
            const auto c = static_cast<std::size_t>(channel);
            CHECK(pixel[c] == numbers[c]);
            CHECK(picture.pixels[picture.index(1, 0) + c] == numbers[c]);
        }
    }
}

TEST_CASE_FIXTURE(Headless, "a size beyond the driver's limit is an error, without a GL error") {
    const int largest = (*context)->info().largest_texture;
    const auto texture = gpu::Texture::make({largest + 1, 1}, Format::rgba32f);
    REQUIRE_FALSE(texture.has_value());
    CHECK(texture.error().front().message.find("can't create a") != std::string::npos);
    CHECK_FALSE(gpu::Canvas::make({1, largest + 1}, Format::r8).has_value());
}
