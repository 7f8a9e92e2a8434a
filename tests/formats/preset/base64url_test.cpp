#include "formats/preset/base64url.h"

#include <doctest/doctest.h>

#include <random>

TEST_CASE("the examples of RFC 4648 are encoded and decoded") {
    // RFC 4648, section 10, without padding.
    for (const auto& [plain, text] : {std::pair<std::string, std::string>{"", ""},
                                      {"f", "Zg"},
                                      {"fo", "Zm8"},
                                      {"foo", "Zm9v"},
                                      {"foob", "Zm9vYg"},
                                      {"fooba", "Zm9vYmE"},
                                      {"foobar", "Zm9vYmFy"}}) {
        CHECK(base64url_encode(plain) == text);
        CHECK(base64url_decode(text) == plain);
    }
    CHECK(base64url_decode("Zg==") == "f");
    CHECK(base64url_encode("\xfb\xff\xfe") == "-__-");
}

TEST_CASE("arbitrary bytes are encoded and decoded unchanged") {
    std::mt19937 random(3);
    for (std::size_t size = 0; size < 100; ++size) {
        std::string bytes(size, '\0');
        for (char& byte : bytes)
            byte = static_cast<char>(random());
        CHECK(base64url_decode(base64url_encode(bytes)) == bytes);
    }
}

TEST_CASE("invalid base64url is rejected") {
    for (const char* text : {"Z", "Zm9vY", "Zh", "Zm9+", "Zm9/", "Zm 9", "Zg===", "Z\xc3\xa9"})
        CHECK_FALSE(base64url_decode(text).has_value());
}
