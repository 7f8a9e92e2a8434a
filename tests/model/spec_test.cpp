#include "model/spec.h"

#include <doctest/doctest.h>

TEST_CASE("a spec is a kind and its settings") {
    const Spec spec = parse_spec("waveform:ch1=sine,f1=2,a1=0.7").value();
    CHECK(spec.kind == "waveform");
    CHECK(std::get<std::string>(spec.settings.at("ch1")) == "sine");
    CHECK(std::get<double>(spec.settings.at("f1")) == 2.0);
    CHECK(parse_spec("stdin").value() == Spec{"stdin", {}});
}

TEST_CASE("the first setting may be a bare word, which stays text") {
    const Spec spec = parse_spec("audio:/music/my song.wav,mode=xy").value();
    CHECK(std::get<std::string>(spec.settings.at("")) == "/music/my song.wav");
    CHECK(std::get<std::string>(parse_spec("text:42").value().settings.at("")) == "42");
}

TEST_CASE("a spec is written as what reads back the same") {
    for (const char* text : {"lissajous:x=3,y=2", "audio:song.wav,mode=xy", "stdin", "text:HELLO"})
        CHECK(to_string(parse_spec(text).value()) == text);
}

TEST_CASE("what is no spec is said in words") {
    for (const char* text : {"", ":x=3", "  "})
        CHECK_FALSE(parse_spec(text).has_value());
    const auto bare = parse_spec("lissajous:x=3,fast");
    REQUIRE_FALSE(bare.has_value());
    CHECK(bare.error().front().message == "'fast' is not of the form key=value");
}
