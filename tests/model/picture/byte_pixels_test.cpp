#include "model/picture/byte_pixels.h"

#include "model/picture/placing.h"
#include "model/picture/prescaled.h"

#include <doctest/doctest.h>

namespace {
// Every pixel differs; the unused byte does too.
Picture byte_picture(Extent extent) {
    Picture picture{extent, 4, Encoding::display, {}};
    const std::size_t count = picture.index(0, extent.height);
    const auto bytes = std::make_shared<std::vector<std::uint8_t>>(count);
    for (std::size_t i = 0; i < count; ++i)
        (*bytes)[i] = static_cast<std::uint8_t>(i * 7);
    picture.bytes = {bytes, bytes->data()};
    return picture;
}
}  // namespace

TEST_CASE("bytes become RGB floats, and floats stay") {
    const Picture made = with_floats(byte_picture({1, 1}));
    CHECK(made.channels == 3);
    CHECK(made.encoding == Encoding::display);
    CHECK(made.pixels == std::vector<float>{14.0f / 255.0f, 7.0f / 255.0f, 0.0f});
    const Picture floats{{1, 1}, 1, Encoding::linear, {0.5f}};
    CHECK(with_floats(floats) == floats);
}

TEST_CASE("bytes are placed like floats") {
    const Picture bytes = byte_picture({5, 3});
    const Picture floats = with_floats(bytes);
    for (const char* text : {"a.png,fit=whole", "a.png,fit=crop", "a.png,fit=integer",
                             "a.png,fit=whole,aspect=2", "a.png,fit=stretch"})
        for (const Extent viewport : {Extent{40, 10}, Extent{10, 40}, Extent{15, 9}}) {
            CAPTURE(text);
            CAPTURE(viewport.width);
            const auto source = parse_source(text);
            REQUIRE(source.has_value());
            const Picture placed_bytes = placed(bytes, *source, viewport);
            CHECK(placed_bytes.pixels.empty());
            CHECK(with_floats(placed_bytes) == placed(floats, *source, viewport));
        }
}

TEST_CASE("bytes have the originals of enlarged pixels") {
    const Picture small = byte_picture({12, 10});
    const auto source = parse_source("a.png,fit=integer");
    const Picture large = placed(small, *source, {36, 30});
    CHECK(found_prescale(large) == 3);
    CHECK(without_prescale(large, 3) == with_floats(small));
}
