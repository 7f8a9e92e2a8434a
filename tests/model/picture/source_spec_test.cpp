#include "model/picture/source_spec.h"

#include <doctest/doctest.h>

TEST_CASE("a source name may contain commas, and its settings follow it") {
    CHECK(parse_source("a, b=c.png") == SourceSpec{"a, b=c.png"});
    CHECK(parse_source("frame_%04d.png,rate=25,loop=off") ==
          SourceSpec{"frame_%04d.png", Fit::stretch, 1.0, 25.0, false});
    CHECK(parse_source("pattern:smpte,fit=crop,size=320x240,aspect=1.2") ==
          SourceSpec{"pattern:smpte,size=320x240", Fit::crop, 1.2});
    CHECK(parse_source("x,fit=whole.png")
              .error()
              .front()
              .message.starts_with("unknown fit 'whole.png'; use one of: stretch, "));
    for (const char* text :
         {"a.png,aspect=0", "a.png,aspect=wide", "a.png,rate=-1", "a.png,loop=yes",
          "a.png,fit=", "", "a.png,shape=wide", "a.png,shape=4:0", "a.png,shape=100:1",
          "a.png,shape=4", "a.png,prescaled=0", "a.png,prescaled=9", "a.png,prescaled=2.5",
          "a.png,shape=4:3,aspect=1.5"})
        CHECK_MESSAGE(!parse_source(text).has_value(), text);
}

TEST_CASE("a source is written without default settings, as text that parses to the same source") {
    for (const char* text :
         {"a.png", "pattern:smpte,size=4x4,fit=integer,aspect=0.9375", "v.mp4,rate=12.5,loop=off",
          "a.png,fit=whole,shape=4:3,prescaled=auto", "a.png,shape=8.5:7,prescaled=8"})
        CHECK(to_string(parse_source(text).value()) == text);
    CHECK(to_string(parse_source("a.png,loop=on,fit=stretch,aspect=1").value()) == "a.png");
}

TEST_CASE("the shape of the whole picture determines the pixel aspect") {
    const SourceSpec television = parse_source("a.png,shape=4:3").value();
    CHECK(pixel_aspect(television, {320, 240}) == 1.0);
    CHECK(pixel_aspect(television, {256, 224}) == doctest::Approx(7.0 / 6.0));
    CHECK(pixel_aspect(television, {640, 240}) == 0.5);
    CHECK(pixel_aspect(parse_source("a.png,aspect=1.5").value(), {256, 224}) == 1.5);
    CHECK(pixel_aspect(parse_source("a.png,shape=square").value(), {256, 224}) == 1.0);
}

TEST_CASE("settings that a text omits are defaults, and settings that it gives override them") {
    SourceSpec usual;
    usual.fit = Fit::whole;
    usual.prescaled = 0;
    CHECK(to_string(parse_source("a.png", usual).value()) == "a.png,fit=whole,prescaled=auto");
    CHECK(to_string(parse_source("a.png,fit=stretch,prescaled=1", usual).value()) == "a.png");
}
