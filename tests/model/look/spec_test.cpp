#include "model/look/spec.h"

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

TEST_CASE("a spec is written as text that parses to the same spec") {
    for (const char* text : {"lissajous:x=3,y=2", "audio:song.wav,mode=xy", "stdin", "text:HELLO"})
        CHECK(to_string(parse_spec(text).value()) == text);
}

TEST_CASE("an invalid spec gives a specific error") {
    for (const char* text : {"", ":x=3", "  "})
        CHECK_FALSE(parse_spec(text).has_value());
    const auto bare = parse_spec("lissajous:x=3,fast");
    REQUIRE_FALSE(bare.has_value());
    CHECK(bare.error().front().message == "expected key=value, got 'fast'");
}

TEST_CASE("a bare text keeps its commas up to the first setting") {
    const Spec spec = parse_spec("audio:Song, Pt. 2.wav,mode=xy").value();
    CHECK(std::get<std::string>(spec.settings.at("")) == "Song, Pt. 2.wav");
    CHECK(std::get<std::string>(spec.settings.at("mode")) == "xy");
    CHECK(std::get<std::string>(parse_spec("text:A,,B").value().settings.at("")) == "A,,B");
}

TEST_CASE("a quoted value may contain any character") {
    const Spec spec = parse_spec(R"(audio:"a, mode=1 \"b\" c\\d=.wav",mode="x,y")").value();
    CHECK(std::get<std::string>(spec.settings.at("")) == R"(a, mode=1 "b" c\d=.wav)");
    CHECK(std::get<std::string>(spec.settings.at("mode")) == "x,y");
    CHECK(std::get<std::string>(parse_spec("audio:7\" mix.wav").value().settings.at("")) ==
          "7\" mix.wav");
    CHECK(parse_spec("audio:\"open").error().front().message.find("missing closing quote") !=
          std::string::npos);
}

TEST_CASE("an equals sign is part of the file name if the kind has no such setting") {
    const HasSetting has_mode = [](std::string_view, std::string_view key) {
        return key == "mode";
    };
    const auto bare = [&](const char* text) {
        const Spec spec = parse_spec(text, has_mode).value();
        const auto found = spec.settings.find("");
        return found == spec.settings.end() ? std::string() : std::get<std::string>(found->second);
    };
    CHECK(bare("audio:a=b.wav") == "a=b.wav");
    CHECK(bare("audio:x = y.mp3,mode=xy") == "x = y.mp3");
    CHECK(bare("audio:mode=b.wav") == "");
    CHECK(bare("audio:mod=xy") == "");  // a misspelt setting
}

TEST_CASE("text with reserved characters is written in quotes") {
    for (const char* file :
         {"Song, Pt. 2.wav", "a=b.wav", "\"q\".wav", " blank.wav", "c\\d,e.wav"}) {
        const Spec spec{"audio", {{"", std::string(file)}, {"mode", std::string("a,b")}}};
        CHECK_MESSAGE(parse_spec(to_string(spec)).value() == spec, to_string(spec));
    }
}
