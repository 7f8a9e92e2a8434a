#include "lab/files/file_preview.h"

#include "io/pictures/picture_file.h"
#include "io/temporary_folder.h"

#include <doctest/doctest.h>

#include <string>

namespace {
std::string little_endian(unsigned int number, int bytes) {
    std::string text;
    for (int i = 0; i < bytes; ++i)
        text += static_cast<char>(number >> (8 * i));
    return text;
}

// A silent WAV of 16-bit samples.
std::string wav(unsigned int rate, unsigned int channels, unsigned int frames) {
    const unsigned int bytes = frames * channels * 2;
    return "RIFF" + little_endian(36 + bytes, 4) + "WAVEfmt " + little_endian(16, 4) +
           little_endian(1, 2) + little_endian(channels, 2) + little_endian(rate, 4) +
           little_endian(rate * channels * 2, 4) + little_endian(channels * 2, 2) +
           little_endian(16, 2) + "data" + little_endian(bytes, 4) + std::string(bytes, '\0');
}

using Lines = std::vector<std::string>;
}  // namespace

TEST_CASE("a sound shows its length, rate and channels") {
    const TemporaryFolder folder;
    CHECK(load_preview(folder.write("a.wav", wav(44100, 2, 44100 * 13))).lines ==
          Lines{"0:13", "44.1 kHz, stereo"});
    CHECK(load_preview(folder.write("b.wav", wav(8000, 1, 8000 * 75))).lines ==
          Lines{"1:15", "8 kHz, mono"});
    CHECK(load_preview(folder.write("c.wav", "no sound")).lines ==
          Lines{"This sound can't be read."});
}

TEST_CASE("a picture shows its size and a small copy") {
    const TemporaryFolder folder;
    const Picture picture{.extent = {800, 400},
                          .channels = 3,
                          .encoding = Encoding::display,
                          .pixels = std::vector<float>(800 * 400 * 3, 0.2f)};
    REQUIRE(save_picture(picture, folder / "a.png").has_value());
    const FilePreview preview = load_preview(folder / "a.png");
    CHECK(preview.lines == Lines{"800 × 400"});
    REQUIRE(preview.picture.has_value());
    CHECK(preview.picture->extent == Extent{384, 192});
    CHECK(preview.picture->pixels[0] == doctest::Approx(51.0 / 255.0));  // 0.2 in 8 bits
    CHECK(load_preview(folder.write("b.png", "broken")).lines ==
          Lines{"This picture can't be read."});
}

TEST_CASE("other files have no preview") {
    const TemporaryFolder folder;
    CHECK_FALSE(has_preview("a.json"));
    CHECK(load_preview(folder.write("a.json", "{}")).lines.empty());
    CHECK(load_preview(folder / "gone.txt").lines.empty());
}
