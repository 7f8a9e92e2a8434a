#include "model/look/format.h"

#include <doctest/doctest.h>

TEST_CASE("every format is found by its name") {
    for (const FormatInfo& info : all_formats()) {
        CHECK(parse_format(info.name) == info.format);
        CHECK(info_of(info.format).name == info.name);
    }
    CHECK(info_of(Format::r32ui).is_integer);
    CHECK(info_of(Format::rgba16ui).is_integer);
    CHECK(info_of(Format::rgba16f).bytes == 8);
    CHECK(info_of(Format::rg16i).bytes == 4);
    CHECK(sample_kind_of(Format::rgba8) == SampleKind::floating);
    CHECK(sample_kind_of(Format::r11f_g11f_b10f) == SampleKind::floating);
    CHECK(sample_kind_of(Format::rgb10_a2ui) == SampleKind::unsigned_integer);
    CHECK(sample_kind_of(Format::rgba32i) == SampleKind::integer);
    CHECK_FALSE(parse_format("rgba64f").has_value());
    CHECK_FALSE(parse_format("").has_value());
}
