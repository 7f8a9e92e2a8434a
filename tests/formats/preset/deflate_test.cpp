#include "formats/preset/deflate.h"

#include <doctest/doctest.h>

#include <random>

TEST_CASE("bytes are compressed and decompressed unchanged") {
    std::mt19937 random(5);
    for (const std::size_t size : {0u, 1u, 65535u, 65536u, 65537u, 200000u}) {
        std::string bytes(size, '\0');
        for (char& byte : bytes)
            byte = static_cast<char>(random() & 15u);
        CHECK(inflate_bytes(deflate_bytes(bytes), size) == bytes);
    }
}

TEST_CASE("a zlib stream of another program is decompressed") {
    // Made by python3 -c 'import zlib; print(zlib.compress(b"hello").hex())'.
    CHECK(inflate_bytes(std::string("\x78\x9c\xcb\x48\xcd\xc9\xc9\x07\x00\x06\x2c\x02\x15", 13),
                        5) == "hello");
}

TEST_CASE("a stream that expands beyond the limit is rejected") {
    const std::string bomb = deflate_bytes(std::string(8000000, 'a'));
    CHECK(bomb.size() < 16000);
    CHECK_FALSE(inflate_bytes(bomb, std::size_t{4} << 20).has_value());
    CHECK_FALSE(inflate_bytes(deflate_bytes("hello"), 4).has_value());
}

TEST_CASE("a truncated or changed stream never decompresses to other bytes") {
    const std::string text = "a text that repeats, a text that repeats";
    const std::string stream = deflate_bytes(text);
    for (std::size_t size = 0; size < stream.size(); ++size)
        CHECK_FALSE(inflate_bytes(stream.substr(0, size), 1000).has_value());
    for (std::size_t at = 2; at < stream.size(); ++at) {
        std::string damaged = stream;
        damaged[at] = static_cast<char>(damaged[at] ^ 0x20);
        CHECK(inflate_bytes(damaged, 1000).value_or(text) == text);  // some bits have no meaning
    }
    CHECK_FALSE(inflate_bytes("garbage", 1000).has_value());
}
