#include "io/pictures/picture_file.h"

#include "about.h"
#include "base/file.h"
#include "io/captured_errors.h"
#include "io/pictures/png_chunks.h"
#include "io/pictures/png_encoder.h"
#include "io/temporary_folder.h"
#include "model/look/color.h"
#include "problems_of.h"

#include <OpenImageIO/imageio.h>
#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <random>

namespace fs = std::filesystem;

namespace {
Picture picture_of(Extent extent, int channels, Encoding encoding, std::vector<float> pixels) {
    return {extent, channels, encoding, std::move(pixels)};
}

// Saves pixels as another program would.
void store(const fs::path& file, const OIIO::ImageSpec& spec, const std::vector<float>& pixels) {
    const auto output = OIIO::ImageOutput::create(file.string());
    REQUIRE(output);
    REQUIRE(output->open(file.string(), spec));
    REQUIRE(output->write_image(OIIO::TypeDesc::FLOAT, pixels.data()));
    REQUIRE(output->close());
}

std::string error_of(const fs::path& file) {
    const auto loaded = load_picture(file);
    REQUIRE_FALSE(loaded.has_value());
    REQUIRE(loaded.error().size() == 1);
    CHECK(loaded.error().front().file == file);
    CHECK(loaded.error().front().message.find('\n') == std::string::npos);
    return loaded.error().front().message;
}

void append_number(std::string& bytes, std::uint32_t number) {
    for (const unsigned shift : {24u, 16u, 8u, 0u})
        bytes += static_cast<char>((number >> shift) & 0xffu);
}
}  // namespace

TEST_CASE("a PNG stores display values rounded to 1/255, with row 0 at the top") {
    const TemporaryFolder folder;
    const Picture picture = picture_of({2, 2}, 3, Encoding::display,
                                       {0.0f, 1.0f, 0.5f, 0.25f, 2.0f, -1.0f,  //
                                        1 / 255.0f, 254.4f / 255, 254.6f / 255, 0.2f, 0.4f, 0.6f});
    REQUIRE(save_picture(picture, folder / "a.png"));
    const auto loaded = load_picture(folder / "a.png");
    REQUIRE(loaded.has_value());
    CHECK(loaded->extent == Extent{2, 2});
    CHECK(loaded->channels == 3);
    CHECK(loaded->encoding == Encoding::display);
    const std::vector<int> expected{0, 255, 128, 64, 255, 0, 1, 254, 255, 51, 102, 153};
    for (std::size_t i = 0; i < expected.size(); ++i)
        CHECK(std::lround(loaded->pixels[i] * 255) == expected[i]);
}

TEST_CASE("a PNG stores linear values sRGB-encoded, and NaN as black") {
    const TemporaryFolder folder;
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float infinity = std::numeric_limits<float>::infinity();
    const Picture picture =
        picture_of({2, 1}, 3, Encoding::linear, {0.214041f, 0.0030f, 1.5f, nan, infinity, 0.5f});
    REQUIRE(save_picture(picture, folder / "a.png"));
    const auto loaded = load_picture(folder / "a.png");
    REQUIRE(loaded.has_value());
    // IEC 61966-2-1: 0.214041 encodes to 0.5, 0.003 to 0.03876 (10), 0.5 to 0.73536 (188).
    const std::vector<int> expected{127, 10, 255, 0, 255, 188};
    for (std::size_t i = 0; i < expected.size(); ++i)
        CHECK(std::abs(std::lround(loaded->pixels[i] * 255) - expected[i]) <= (i == 0 ? 1 : 0));
}

TEST_CASE("grey and RGBA pictures become RGB in a PNG") {
    const TemporaryFolder folder;
    REQUIRE(save_picture(picture_of({1, 1}, 1, Encoding::display, {0.4f}), folder / "grey.png"));
    const std::vector<float> rgba{0.2f, 0.4f, 0.6f, 0.0f};
    REQUIRE(save_picture(picture_of({1, 1}, 4, Encoding::display, rgba), folder / "rgba.png"));
    const auto grey = load_picture(folder / "grey.png");
    REQUIRE(grey.has_value());
    REQUIRE(grey->pixels.size() == 3);
    for (const float value : grey->pixels)
        CHECK(value == doctest::Approx(102 / 255.0));
    const auto rgb = load_picture(folder / "rgba.png");
    REQUIRE(rgb.has_value());
    CHECK(rgb->channels == 3);
    CHECK(rgb->pixels[0] == doctest::Approx(51 / 255.0));
    CHECK(rgb->pixels[2] == doctest::Approx(153 / 255.0));
}

TEST_CASE("the same pixels give the same bytes") {
    const TemporaryFolder folder;
    std::vector<float> pixels(64 * 64 * 4);
    std::mt19937 random(1);
    for (float& pixel : pixels)
        pixel = std::uniform_real_distribution<float>(-1, 3)(random);
    const Picture picture = picture_of({64, 64}, 4, Encoding::linear, pixels);
    REQUIRE(save_picture(picture, folder / "first.png"));
    REQUIRE(save_picture(picture, folder / "first.exr"));
    ::sleep(1);  // a timestamp in the file would differ
    REQUIRE(save_picture(picture, folder / "second.png"));
    REQUIRE(save_picture(picture, folder / "second.exr"));
    CHECK(content_of(folder / "first.png") == content_of(folder / "second.png"));
    CHECK(content_of(folder / "first.exr") == content_of(folder / "second.exr"));
    CHECK(encode_png(picture).value() == content_of(folder / "first.png"));
}

TEST_CASE("an EXR stores exact values, also under zero alpha") {
    const TemporaryFolder folder;
    const Picture picture = picture_of({2, 1}, 4, Encoding::linear,
                                       {-1.5f, 1e-7f, 70000.0f, 0.25f, 0.1f, 0.2f, 0.3f, 0.0f});
    REQUIRE(save_picture(picture, folder / "a.exr"));
    const auto loaded = load_picture(folder / "a.exr");
    REQUIRE(loaded.has_value());
    CHECK(*loaded == picture);

    const Picture grey = picture_of({1, 2}, 1, Encoding::linear, {0.1f, 1000.0f});
    REQUIRE(save_picture(grey, folder / "half.exr", {.half = true}));
    const auto half = load_picture(folder / "half.exr");
    REQUIRE(half.has_value());
    CHECK(half->channels == 1);
    CHECK(half->pixels[0] != 0.1f);
    CHECK(half->pixels[0] == about(0.1f, 1.0 / 2048));
    CHECK(half->pixels[1] == 1000.0f);
}

TEST_CASE("premultiplied alpha of an EXR is divided out, except where alpha is 0") {
    const TemporaryFolder folder;
    store(folder / "a.exr", OIIO::ImageSpec(2, 1, 4, OIIO::TypeDesc::FLOAT),
          {0.25f, 0.5f, 0.0f, 0.5f, 3.0f, 2.0f, 1.0f, 0.0f});
    const auto loaded = load_picture(folder / "a.exr");
    REQUIRE(loaded.has_value());
    CHECK(loaded->pixels == std::vector<float>{0.5f, 1.0f, 0.0f, 0.5f, 3.0f, 2.0f, 1.0f, 0.0f});
    CHECK(loaded->encoding == Encoding::linear);
}

TEST_CASE("PNG colours are not changed by their alpha, and grey with alpha becomes RGBA") {
    const TemporaryFolder folder;
    OIIO::ImageSpec spec(1, 1, 4, OIIO::TypeDesc::UINT8);
    spec.attribute("oiio:UnassociatedAlpha", 1);
    store(folder / "rgba.png", spec, {0.2f, 0.4f, 0.6f, 0.2f});
    const auto rgba = load_picture(folder / "rgba.png");
    REQUIRE(rgba.has_value());
    for (const auto& [channel, value] : {std::pair{0u, 51}, {1u, 102}, {2u, 153}, {3u, 51}})
        CHECK(std::lround(rgba->pixels[channel] * 255) == value);

    OIIO::ImageSpec grey(1, 1, 2, OIIO::TypeDesc::UINT8);
    grey.channelnames = {"Y", "A"};
    grey.alpha_channel = 1;
    grey.attribute("oiio:UnassociatedAlpha", 1);
    store(folder / "grey.png", grey, {0.4f, 0.8f});
    const auto read = load_picture(folder / "grey.png");
    REQUIRE(read.has_value());
    CHECK(read->channels == 4);
    CHECK(std::lround(read->pixels[2] * 255) == 102);
    CHECK(std::lround(read->pixels[3] * 255) == 204);
}

TEST_CASE("a JPEG is display-encoded and rotated by its orientation tag; an HDR is linear") {
    const TemporaryFolder folder;
    OIIO::ImageSpec spec(32, 16, 3, OIIO::TypeDesc::UINT8);
    spec.attribute("Orientation", 6);  // stored rotated: its left side is the top of the scene
    std::vector<float> pixels;
    for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 32; ++x)
            pixels.insert(pixels.end(), 3, x < 16 ? 1.0f : 0.0f);
    store(folder / "a.jpg", spec, pixels);
    const auto jpeg = load_picture(folder / "a.jpg");
    REQUIRE(jpeg.has_value());
    CHECK(jpeg->encoding == Encoding::display);
    CHECK(jpeg->extent == Extent{16, 32});
    CHECK(jpeg->pixels[jpeg->index(8, 4)] > 0.9f);
    CHECK(jpeg->pixels[jpeg->index(8, 28)] < 0.1f);

    store(folder / "a.hdr", OIIO::ImageSpec(1, 1, 3, OIIO::TypeDesc::FLOAT), {8.0f, 4.0f, 2.0f});
    const auto hdr = load_picture(folder / "a.hdr");
    REQUIRE(hdr.has_value());
    CHECK(hdr->encoding == Encoding::linear);
    CHECK(hdr->pixels[0] == about(8.0, 0.02));
}

TEST_CASE("an invalid picture file gives one clear error") {
    const TemporaryFolder folder;
    CHECK(error_of(folder / "none.png") == "file not found");
    CHECK(error_of(folder.path()) == "this is a folder, not a file");
    CHECK(error_of(folder.write("empty.png", "")) == "the file is empty");
    CHECK(error_of(folder.write("text.png", "hello, world\n"))
              .starts_with("can't read the picture: "));
    CHECK(error_of(folder.write("text.exr", "hello, world\n"))
              .starts_with("can't read the picture: "));
    CHECK(error_of(folder.write("what.qqq", "hello, world\n"))
              .starts_with("can't read the picture: "));
    store(folder / "five.exr", OIIO::ImageSpec(1, 1, 5, OIIO::TypeDesc::FLOAT), {1, 1, 1, 1, 1});
    CHECK(error_of(folder / "five.exr") ==
          "the picture must have 1 (grey), 3 (RGB) or 4 (RGBA) channels, got 5");
}

TEST_CASE("the format of a picture is detected from its first bytes, not from its name") {
    const TemporaryFolder folder;
    for (const char* format : {"png", "jpg", "exr", "tif", "bmp", "gif", "webp", "ppm", "hdr"}) {
        CAPTURE(format);
        const fs::path named = folder / (std::string("a.") + format);
        const bool is_light = std::string_view("exr hdr").find(format) != std::string_view::npos;
        store(named,
              OIIO::ImageSpec(8, 8, 3, is_light ? OIIO::TypeDesc::FLOAT : OIIO::TypeDesc::UINT8),
              std::vector<float>(8 * 8 * 3, 1.0f));
        fs::rename(named, folder / "picture");
        const auto loaded = load_picture(folder / "picture");
        REQUIRE_MESSAGE(loaded.has_value(), problems_of(loaded));
        CHECK(loaded->pixels[0] > 0.98f);
    }
}

TEST_CASE("a huge file of zeros is rejected at its start") {
    const TemporaryFolder folder;
    const fs::path file = folder.write("huge.png", "");
    fs::resize_file(file, std::uintmax_t{1} << 30);
    CHECK(error_of(file).starts_with("can't read the picture: "));
}

TEST_CASE("an absurd picture size is rejected before memory is allocated") {
    const TemporaryFolder folder;
    std::string png = "\x89PNG\r\n\x1a\n";
    append_number(png, 13);
    std::string header = "IHDR";
    append_number(header, 500000);
    append_number(header, 500000);
    header += std::string("\x08\x02\x00\x00\x00", 5);
    png += header;
    append_number(png, 0x8cea9d6e);  // either the wrong checksum or the size is rejected
    CHECK_FALSE(error_of(folder.write("large.png", png)).empty());
    store(folder / "wide.exr", OIIO::ImageSpec(16385, 1, 1, OIIO::TypeDesc::HALF),
          std::vector<float>(16385));
    CHECK(error_of(folder / "wide.exr").starts_with("the picture is too large: 16385 x 1 px"));
}

TEST_CASE("a TIFF with an absurd strip is rejected before memory is allocated") {
    const TemporaryFolder folder;
    store(folder / "a.tif", OIIO::ImageSpec(8, 8, 3, OIIO::TypeDesc::UINT8),
          std::vector<float>(8 * 8 * 3));
    std::string bytes = read_bytes(folder / "a.tif").value();
    const std::size_t rows_per_strip =
        bytes.find(std::string("\x16\x01\x03\x00\x01\x00\x00\x00", 8));
    REQUIRE(rows_per_strip != std::string::npos);
    bytes.replace(rows_per_strip, 12,
                  std::string("\x16\x01\x04\x00\x01\x00\x00\x00\x00\x00\x00\x40", 12));
    CHECK(error_of(folder.write("b.tif", bytes)) ==
          "the picture is damaged: its strips have 1073741824 rows, but it has 8");
}

TEST_CASE("a truncated or damaged picture never crashes and gives an error") {
    const TemporaryFolder folder;
    std::vector<float> pixels(24 * 24 * 3);
    std::mt19937 random(7);
    for (float& pixel : pixels)
        pixel = std::uniform_real_distribution<float>(0, 1)(random);
    const Picture picture = picture_of({24, 24}, 3, Encoding::display, pixels);
    for (const char* name : {"a.png", "a.exr"}) {
        REQUIRE(save_picture(picture, folder / name));
        const std::string whole = content_of(folder / name);
        for (std::size_t size = 1; size < whole.size() * 3 / 4; size += 13)
            CHECK_FALSE(
                error_of(folder.write(std::string("cut-") + name, whole.substr(0, size))).empty());
        for (int trial = 0; trial < 150; ++trial) {
            std::string damaged = whole;
            damaged[random() % damaged.size()] = static_cast<char>(random());
            const auto loaded = load_picture(folder.write(std::string("bad-") + name, damaged));
            CHECK((loaded.has_value() || !loaded.error().front().message.empty()));
        }
    }
}

TEST_CASE("a truncated JPEG is loaded with a note") {
    const fs::path inputs = fs::path(AFTERGLOW_SOURCE_DIR) / "tests/inputs/pic";
    const CapturedErrors errors;
    const auto cut = load_picture(inputs / "cut.jpg");
    REQUIRE_MESSAGE(cut.has_value(), problems_of(cut));
    CHECK(cut->note.starts_with("the file ends early, so the rest is filled in: "));

    const TemporaryFolder folder;
    store(folder / "whole.jpg", OIIO::ImageSpec(16, 16, 3, OIIO::TypeDesc::UINT8),
          std::vector<float>(16 * 16 * 3, 0.5f));
    CHECK(load_picture(folder / "whole.jpg")->note.empty());
}

TEST_CASE("an EXR is cropped or padded with black to its display window") {
    const auto file = load_picture(fs::path(AFTERGLOW_SOURCE_DIR) / "tests/inputs/pic/window.exr");
    REQUIRE_MESSAGE(file.has_value(), problems_of(file));
    CHECK(file->extent == Extent{64, 48});
    CHECK(file->pixels[file->index(0, 0)] == 0.0f);
    CHECK(file->pixels[file->index(63, 47)] == 0.0f);

    const TemporaryFolder folder;
    OIIO::ImageSpec spec(2, 1, 1, OIIO::TypeDesc::FLOAT);
    spec.x = 1;
    spec.y = 2;
    spec.full_width = 4;
    spec.full_height = 3;
    store(folder / "crop.exr", spec, {0.25f, 0.5f});
    const auto crop = load_picture(folder / "crop.exr");
    REQUIRE_MESSAGE(crop.has_value(), problems_of(crop));
    CHECK(crop->extent == Extent{4, 3});
    CHECK(crop->pixels == std::vector<float>{0, 0, 0, 0, 0, 0, 0, 0, 0, 0.25f, 0.5f, 0});

    // Rendered beyond the picture's edges, with a window that does not start at 0.
    OIIO::ImageSpec beyond(3, 2, 1, OIIO::TypeDesc::FLOAT);
    beyond.x = 4;
    beyond.y = -1;
    beyond.full_x = 5;
    beyond.full_y = 0;
    beyond.full_width = 1;
    beyond.full_height = 1;
    store(folder / "over.exr", beyond, {1, 2, 3, 4, 5, 6});
    const auto over = load_picture(folder / "over.exr");
    REQUIRE_MESSAGE(over.has_value(), problems_of(over));
    CHECK(over->extent == Extent{1, 1});
    CHECK(over->pixels == std::vector<float>{5});
}

TEST_CASE("a PNG with a bad header gives one error, and libpng prints nothing") {
    const TemporaryFolder folder;
    const auto png = [&](const std::string& header, const std::string& rest) {
        const std::string bytes =
            std::string(png_signature()) + png_chunk("IHDR", header) + rest + png_chunk("IEND", "");
        CapturedErrors errors;
        std::string message = error_of(folder.write("a.png", bytes));
        CHECK(errors.text().empty());
        return message;
    };
    const std::string pixels = png_chunk("IDAT", "x");
    const auto header = [](std::uint32_t width, std::uint32_t height, const std::string& rest) {
        std::string bytes;
        append_number(bytes, width);
        append_number(bytes, height);
        return bytes + rest;
    };
    const std::string rgb("\x08\x02\0\0\0", 5);
    CHECK(png(header(0, 4, rgb), pixels) == "the PNG is damaged: its size is 0 x 4 px");
    CHECK(png(header(4, 0, rgb), pixels) == "the PNG is damaged: its size is 4 x 0 px");
    CHECK(png(header(0x80000000u, 4, rgb), pixels).find("its size is") != std::string::npos);
    CHECK(png(header(4, 4, std::string("\x03\x02\0\0\0", 5)), pixels) ==
          "the PNG is damaged: bit depth 3 is invalid for colour type 2");
    CHECK(png(header(4, 4, std::string("\x08\x05\0\0\0", 5)), pixels).find("colour type 5") !=
          std::string::npos);
    CHECK(
        png(header(4, 4, std::string("\x08\x02\x01\0\0", 5)), pixels).find("unknown compression") !=
        std::string::npos);
    CHECK(png(header(4, 4, std::string("\x08\x03\0\0\0", 5)), pixels).find("no palette") !=
          std::string::npos);
    CHECK(png(header(4, 4, rgb), "").find("no pixels") != std::string::npos);
    CHECK(png("short", pixels).find("no header") != std::string::npos);
}

TEST_CASE("saving a picture fails for unknown formats and impossible paths") {
    const TemporaryFolder folder;
    const Picture picture = picture_of({1, 1}, 1, Encoding::display, {0.4f});
    const auto wrong = save_picture(picture, folder / "a.bmp");
    REQUIRE_FALSE(wrong.has_value());
    CHECK(wrong.error().front().message ==
          "can't save the picture: the file name must end in .png or .exr");
    folder.write("file", "");
    CHECK_FALSE(save_picture(picture, folder / "file/a.png").has_value());
}
