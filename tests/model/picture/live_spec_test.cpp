#include "model/picture/live_spec.h"

#include "model/picture/source_spec.h"

#include <doctest/doctest.h>

namespace {
LiveSpec parsed(const std::string& text) {
    const auto source = parse_source(text);
    REQUIRE(source.has_value());
    REQUIRE(source->is_live());
    const auto live = parse_live(source->picture);
    REQUIRE(live.has_value());
    return *live;
}

std::string refusal(const std::string& text) {
    const auto live = parse_live(text);
    return live ? "" : live.error().front().message;
}
}  // namespace

TEST_CASE("a window is named by its title, which may contain commas") {
    const LiveSpec live = parsed("window:Editor, file=a.txt - main,fit=whole,rate=30");
    CHECK(live.kind == LiveKind::window);
    CHECK(live.name == "Editor, file=a.txt - main");
    CHECK(parse_source("window:Terminal,rate=30")->rate == 30.0);
}

TEST_CASE("a screen has a display, an area and a cursor") {
    CHECK(parsed("screen:").name.empty());
    CHECK_FALSE(parsed("screen:").area.has_value());
    CHECK(parsed("screen::1,cursor=on").name == ":1");
    CHECK(parsed("screen::1,cursor=on").has_cursor);
    const ScreenArea area{10, 20, {640, 480}};
    CHECK(parsed("screen:area=10x20+640+480") == parsed("screen:,area=10x20+640+480"));
    CHECK(parsed("screen:area=10x20+640+480,fit=crop").area == area);
}

TEST_CASE("a camera and a pipe have a size") {
    const LiveSpec camera = parsed("camera:/dev/video0,size=1280x720,rate=25");
    CHECK(camera.name == "/dev/video0");
    CHECK(camera.size == Extent{1280, 720});
    const LiveSpec pipe = parsed("pipe:size=64x48,format=rgb24,rate=30");
    CHECK(pipe.kind == LiveKind::pipe);
    CHECK(pipe.format == "rgb24");
    CHECK(parsed("pipe:/tmp/fifo").name == "/tmp/fifo");
}

TEST_CASE("a wrong live source is refused with an example") {
    CHECK(refusal("window:") == "'window:' needs a title, such as window:Terminal");
    CHECK(refusal("camera:") == "'camera:' needs a device, such as camera:/dev/video0");
    CHECK(refusal("screen:area=640x480") ==
          "'area=640x480': expected XxY+W+H, such as area=0x0+640+480");
    CHECK(refusal("screen:area=0x0+0+480") ==
          "'area=0x0+0+480': expected XxY+W+H, such as area=0x0+640+480");
    CHECK(refusal("screen:cursor=yes") == "'cursor=yes': expected 'on' or 'off'");
    CHECK(refusal("pipe:size=64x48") == "raw video needs both size=WxH and format=NAME");
    CHECK(refusal("pipe:format=a;b,size=2x2") ==
          "'format=a;b': expected a pixel format of FFmpeg, such as format=rgb24");
    CHECK(refusal("camera:/dev/video0,area=0x0+1+1") ==
          "unknown setting 'area=0x0+1+1'; use one of: size, rate");
}
