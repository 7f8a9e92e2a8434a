#include "io/capture/ppm_stream.h"

#include <doctest/doctest.h>

TEST_CASE("pictures come out of a stream when their last byte has arrived") {
    PpmStream stream;
    const std::string picture =
        std::string("P6\n2 1\n255\n") + '\xFF' + '\x00' + '\x33' + '\x00' + '\xFF' + '\x66';
    for (const char byte : picture.substr(0, picture.size() - 1)) {
        stream.add({&byte, 1});
        const auto early = stream.take();
        REQUIRE(early.has_value());
        CHECK_FALSE(early->has_value());
    }
    stream.add(picture.substr(picture.size() - 1));
    stream.add("P6\n1 1\n255\nabc");
    const auto first = stream.take();
    REQUIRE(first.has_value());
    REQUIRE(first->has_value());
    CHECK((*first)->extent == Extent{2, 1});
    CHECK((*first)->encoding == Encoding::display);
    CHECK((*first)->pixels == std::vector<float>{1.0f, 0.0f, 0.2f, 0.0f, 1.0f, 0.4f});
    const auto second = stream.take();
    REQUIRE(second.has_value());
    CHECK(second->has_value());  // of another size
    CHECK_FALSE(stream.take()->has_value());
}

TEST_CASE("a stream of something else is refused") {
    for (const char* text : {"P5\n1 1\n255\nabc", "P6\n1 1\n65535\nabcdef", "P6\n-1 1\n255\n",
                             "P6\n99999 1\n255\n", "P6\nwide high\n255\n"}) {
        PpmStream stream;
        stream.add(text);
        CAPTURE(text);
        CHECK_FALSE(stream.take().has_value());
    }
    PpmStream endless;
    endless.add(std::string(100, 'P'));
    CHECK_FALSE(endless.take().has_value());
}
