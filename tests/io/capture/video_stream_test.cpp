#include "io/capture/video_stream.h"

#include "io/temporary_folder.h"

#include <doctest/doctest.h>

#include <fstream>

namespace {
// Two pictures of 2x2 pixels, 8 bits, 4:4:4, white and black in limited range.
std::string recording() {
    const auto frame = [](char luma) {
        return "FRAME\n" + std::string(4, luma) + std::string(8, '\x80');
    };
    return "YUV4MPEG2 W2 H2 F25:1 Ip A1:1 C444\n" + frame('\xEB') + frame('\x10');
}
}  // namespace

TEST_CASE("a camera is opened with its size and rate") {
    LiveSpec spec{LiveKind::camera, "/dev/video3", {}, false, {640, 480}, {}};
    CHECK(camera_options(spec, 25.0) ==
          std::vector<std::string>{"-fflags", "nobuffer", "-f", "v4l2", "-video_size", "640x480",
                                   "-framerate", "25", "-i", "/dev/video3"});
    spec.size = {};
    CHECK(camera_options(spec, 0.0) ==
          std::vector<std::string>{"-fflags", "nobuffer", "-f", "v4l2", "-i", "/dev/video3"});
    spec.name = "/dev/no-such-camera";
    const auto missing = open_camera(spec, 0.0);
    REQUIRE_FALSE(missing.has_value());
    CHECK(missing.error().front().message ==
          "camera '/dev/no-such-camera' not found. Plug it in, or choose another device.");
}

TEST_CASE("a recorded device gives its pictures, then says that it has ended") {
    const TemporaryFolder folder;
    const std::string file = (folder.path() / "camera.y4m").string();
    std::ofstream(file, std::ios::binary) << recording();
    auto stream = open_video_stream({"-f", "yuv4mpegpipe", "-i", file}, "the camera 'recorded'");
    REQUIRE(stream.has_value());
    for (const float wanted : {1.0f, 0.0f}) {
        const auto picture = (*stream)->read(20.0);
        REQUIRE(picture.has_value());
        REQUIRE(picture->has_value());
        CHECK((*picture)->extent == Extent{2, 2});
        CHECK((*picture)->pixels == std::vector<float>(12, wanted));
    }
    const auto after = (*stream)->read(20.0);
    REQUIRE_FALSE(after.has_value());
    CHECK(after.error().front().message == "the video from the camera 'recorded' has ended");
}
