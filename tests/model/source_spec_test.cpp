#include "model/source_spec.h"

#include <doctest/doctest.h>

TEST_CASE("a source keeps its own commas, its settings stand behind") {
    CHECK(parse_source("a, b=c.png") == SourceSpec{"a, b=c.png"});
    CHECK(parse_source("frame_%04d.png,rate=25,loop=off") ==
          SourceSpec{"frame_%04d.png", Fit::stretch, 1.0, 25.0, false});
    CHECK(parse_source("pattern:smpte,fit=crop,size=320x240,aspect=1.2") ==
          SourceSpec{"pattern:smpte,size=320x240", Fit::crop, 1.2});
    CHECK(parse_source("x,fit=whole.png")
              .error()
              .front()
              .message.starts_with("'fit=whole.png': there is no such fit; there are: stretch, "));
    for (const char* text : {"a.png,aspect=0", "a.png,aspect=wide", "a.png,rate=-1",
                             "a.png,loop=yes", "a.png,fit=", ""})
        CHECK_MESSAGE(!parse_source(text).has_value(), text);
}

TEST_CASE("a source is written as it is read, without what is as usual") {
    for (const char* text :
         {"a.png", "pattern:smpte,size=4x4,fit=integer,aspect=0.9375", "v.mp4,rate=12.5,loop=off"})
        CHECK(to_string(parse_source(text).value()) == text);
    CHECK(to_string(parse_source("a.png,loop=on,fit=stretch,aspect=1").value()) == "a.png");
}
