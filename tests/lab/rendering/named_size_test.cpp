#include "lab/rendering/named_size.h"

#include <doctest/doctest.h>

TEST_CASE("sizes have names, or are typed as numbers") {
    CHECK(parse_extent("720p") == Extent{1280, 720});
    CHECK(parse_extent("2160p") == Extent{3840, 2160});
    CHECK(parse_extent("square") == Extent{1080, 1080});
    CHECK(parse_extent("portrait") == Extent{1080, 1920});
    CHECK(parse_extent("640x480") == Extent{640, 480});
    CHECK(parse_extent("640 × 480") == Extent{640, 480});
    for (const char* text : {"", "x", "640", "0x5", "16385x1", "5x-1", "5x5x5", "720P"}) {
        CAPTURE(text);
        CHECK(!parse_extent(text));
    }
}
