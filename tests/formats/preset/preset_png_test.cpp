#include "formats/preset/preset_png.h"

#include "formats/preset/deflate.h"
#include "formats/preset/preset_format.h"
#include "formats/preset/sample_preset.h"
#include "io/pictures/picture_file.h"
#include "io/pictures/png_chunks.h"
#include "io/pictures/png_encoder.h"
#include "io/temporary_folder.h"

#include <doctest/doctest.h>

#include <random>

namespace {
Picture sample_picture() {
    return {{2, 1}, 3, Encoding::display, {0.0f, 1.0f, 0.2f, 0.4f, 0.6f, 0.8f}};
}

std::string sample_png() {
    return encode_png(sample_picture()).value();
}

// The sample with one more chunk after its IHDR chunk.
std::string with_chunk(std::string_view type, std::string_view data) {
    std::string png = sample_png();
    png.insert(8 + 25, png_chunk(type, data));
    return png;
}

std::string png_error(std::string_view png) {
    const auto preset = preset_from_png(png, "a.png");
    REQUIRE_FALSE(preset.has_value());
    CHECK(preset.error().front().file == "a.png");
    return preset.error().front().message;
}

const std::string keyword("afterglow-preset\0", 17);
}  // namespace

TEST_CASE("a preset is stored in a PNG, and the picture stays unchanged") {
    const auto png = with_preset(sample_png(), sample_preset());
    REQUIRE(png.has_value());
    CHECK(preset_from_png(*png, "a.png") == sample_preset());
    const TemporaryFolder folder;
    const auto file = folder.write("a.png", *png);
    CHECK(load_preset(file) == sample_preset());
    CHECK(load_picture(file) == load_picture(folder.write("b.png", sample_png())));
}

TEST_CASE("a second preset replaces the first one") {
    Preset other = sample_preset();
    other.name = "another";
    const auto first = with_preset(sample_png(), sample_preset());
    const auto second = with_preset(first.value(), other);
    CHECK(preset_from_png(second.value(), "a.png") == other);
    CHECK(second == with_preset(sample_png(), other));
}

TEST_CASE("every type of text chunk is read") {
    const std::string json = preset_to_json(sample_preset());
    CHECK(preset_from_png(with_chunk("tEXt", keyword + json), "a.png") == sample_preset());
    CHECK(preset_from_png(with_chunk("zTXt", keyword + '\0' + deflate_bytes(json)), "a.png") ==
          sample_preset());
    CHECK(preset_from_png(with_chunk("iTXt", keyword + std::string("\0\0en\0", 5) + '\0' + json),
                          "a.png") == sample_preset());
}

TEST_CASE("pictures without a preset and damaged presets give a specific error") {
    CHECK(png_error(sample_png()) == "the PNG doesn't contain a preset");
    CHECK(png_error("text") == "not a PNG file");
    CHECK(png_error(with_chunk("tEXt", "afterglow-preset")) == "the PNG doesn't contain a preset");
    const std::string damaged = "the preset in the PNG is damaged";
    CHECK(png_error(with_chunk("iTXt", keyword)) == damaged);
    CHECK(png_error(with_chunk("iTXt", keyword + std::string("\1\0", 2))) == damaged);
    CHECK(png_error(with_chunk("iTXt", keyword + std::string("\1\0en", 4))) == damaged);
    CHECK(png_error(with_chunk("iTXt", keyword + std::string("\1\0\0\0", 4) + "garbage")) ==
          damaged);
    CHECK(png_error(with_chunk("zTXt", keyword)) == damaged);
    CHECK(png_error(with_chunk(
              "zTXt", keyword + '\0' + deflate_bytes(std::string(5000000, ' ')))) == damaged);
    CHECK(png_error(with_chunk("tEXt", keyword + "{}")) ==
          "the preset in the PNG is invalid: 'format' is missing");
    CHECK_FALSE(with_preset("text", sample_preset()).has_value());
}

TEST_CASE("a PNG truncated or changed anywhere is rejected") {
    const std::string png = with_preset(sample_png(), sample_preset()).value();
    for (std::size_t size = 0; size < png.size(); ++size)
        CHECK_FALSE(png_error(std::string_view(png).substr(0, size)).empty());
    std::mt19937 random(21);
    for (int trial = 0; trial < 3000; ++trial) {
        std::string changed = png;
        const std::size_t at = random() % changed.size();
        changed[at] = static_cast<char>(changed[at] ^ (1 + random() % 255));
        CHECK_FALSE(png_error(changed).empty());
    }
}
