#include "base/packed.h"

#include <doctest/doctest.h>

#include <limits>

TEST_CASE("packed values are read back in order, up to the end") {
    Packer packer;
    packer.add(std::uint64_t{7});
    packer.add(std::string_view("one\0two", 7));
    packer.add(std::numeric_limits<std::uint64_t>::max());
    Unpacker read(packer.bytes());
    CHECK(read.number() == 7);
    CHECK(read.text() == std::string_view("one\0two", 7));
    CHECK_FALSE(read.is_at_end());
    CHECK(read.number() == std::numeric_limits<std::uint64_t>::max());
    CHECK(read.is_at_end());
}

TEST_CASE("a number is packed in little-endian byte order") {
    Packer packer;
    packer.add(std::uint64_t{0x0102});
    CHECK(packer.bytes() == std::string_view("\x02\x01\0\0\0\0\0\0", 8));
}

TEST_CASE("data truncated at any byte is an error, and later reads return nothing") {
    Packer packer;
    packer.add(std::string_view("light"));
    packer.add(std::uint64_t{1});
    for (std::size_t size = 0; size < packer.bytes().size(); ++size) {
        Unpacker read(std::string_view(packer.bytes()).substr(0, size));
        static_cast<void>(read.text());
        CHECK(read.number() == 0);
        CHECK_FALSE(read.is_good());
        CHECK(read.text().empty());
    }
}

TEST_CASE("a size or count larger than the remaining data is an error") {
    for (const std::uint64_t size : {std::uint64_t{9}, std::numeric_limits<std::uint64_t>::max()}) {
        Packer packer;
        packer.add(size);
        packer.add(std::uint64_t{0});
        Unpacker read(packer.bytes());
        CHECK(read.count() == 0);
        CHECK_FALSE(read.is_good());
    }
    Packer packer;
    packer.add(std::uint64_t{3});
    Unpacker read(packer.bytes());
    CHECK(read.number(2) == 0);
    CHECK_FALSE(read.is_good());
}
