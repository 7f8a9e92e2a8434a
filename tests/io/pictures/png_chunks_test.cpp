#include "io/pictures/png_chunks.h"

#include <doctest/doctest.h>

#include <random>

namespace {
// The smallest valid PNG, one grey pixel, a hex dump known from texts about the format.
const std::string smallest(
    "\x89PNG\r\n\x1a\n"
    "\0\0\0\rIHDR\0\0\0\1\0\0\0\1\x08\0\0\0\0\x3a\x7e\x9b\x55"
    "\0\0\0\nIDAT\x78\x9c\x63\x60\0\0\0\x02\0\x01\x48\xaf\xa4\x71"
    "\0\0\0\0IEND\xae\x42\x60\x82",
    8 + 25 + 22 + 12);

std::string chunk_error(std::string_view bytes) {
    const auto chunks = parse_png_chunks(bytes);
    REQUIRE_FALSE(chunks.has_value());
    return chunks.error().front().message;
}
}  // namespace

TEST_CASE("PNG chunks are parsed with type and data") {
    const std::string bytes = smallest + "what follows does not count";
    const auto chunks = parse_png_chunks(bytes);
    REQUIRE(chunks.has_value());
    REQUIRE(chunks->size() == 3);
    CHECK((*chunks)[0].type == "IHDR");
    CHECK((*chunks)[0].data.size() == 13);
    CHECK((*chunks)[1].type == "IDAT");
    CHECK((*chunks)[2].whole == std::string_view("\0\0\0\0IEND\xae\x42\x60\x82", 12));
}

TEST_CASE("a PNG chunk is written with length and checksum") {
    CHECK(png_chunk("IEND", "") == std::string("\0\0\0\0IEND\xae\x42\x60\x82", 12));
    CHECK(png_chunk("IHDR", std::string_view("\0\0\0\1\0\0\0\1\x08\0\0\0\0", 13)) ==
          smallest.substr(8, 25));
}

TEST_CASE("a PNG truncated anywhere or changed in any byte is rejected") {
    CHECK(chunk_error("") == "not a PNG file");
    CHECK(chunk_error("GIF89a") == "not a PNG file");
    for (std::size_t size = 0; size < smallest.size(); ++size)
        CHECK_FALSE(chunk_error(smallest.substr(0, size)).empty());
    for (std::size_t at = 0; at < smallest.size(); ++at) {
        std::string damaged = smallest;
        damaged[at] = static_cast<char>(damaged[at] ^ 0x11);
        CHECK_FALSE(chunk_error(damaged).empty());
    }
    CHECK(chunk_error(std::string(png_signature()) +
                      std::string("\xff\xff\xff\xffIHDR\0\0\0\0", 12)) ==
          "the PNG is damaged: it ends early");
    CHECK(chunk_error(std::string(png_signature()) + png_chunk("IEND", "")) ==
          "the PNG is damaged: it doesn't start with its header");
}
