#include "io/virtual_camera/v4l2_camera.h"

#include "io/system/child_process.h"
#include "io/temporary_folder.h"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <fstream>
#include <iterator>

namespace {
// What a recorded device gets for one picture of this colour.
std::string recorded(Extent extent, std::array<int, 3> color) {
    const TemporaryFolder folder;
    const auto file = folder.path() / "device.yuv";
    auto process = ChildProcess::start(
        camera_command(extent, frame_rate_fraction(60.0), {"rawvideo", file.string()}),
        {.inputs = 1});
    REQUIRE(process);
    std::string rgb;
    for (int i = 0; i < extent.width * extent.height; ++i)
        for (const int channel : color)
            rgb += static_cast<char>(channel);
    CHECK(process->feed(0, rgb));
    process->end_input(0);
    CHECK(process->finish());
    std::ifstream read(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(read), {}};
}

int byte_at(const std::string& bytes, std::size_t index) {
    return static_cast<unsigned char>(bytes[index]);
}
}  // namespace

TEST_CASE("a V4L2 camera sends planar YUV 4:2:0 with the colours of ITU-R BT.601") {
    // Y = 16 + 65.481 R + 128.553 G + 24.966 B, Cb = 128 + (B - Y') * 112 / 0.886,
    // Cr = 128 + (R - Y') * 112 / 0.701, with R, G, B and Y' = 0.299 R + 0.587 G + 0.114 B from 0
    // to 1.
    for (const auto& [red, green, blue] :
         {std::array{255, 255, 255}, {0, 0, 0}, {255, 0, 0}, {0, 255, 0}, {20, 60, 220}}) {
        const double r = red / 255.0;
        const double g = green / 255.0;
        const double b = blue / 255.0;
        const double luma = 0.299 * r + 0.587 * g + 0.114 * b;
        const std::string bytes = recorded({8, 4}, {red, green, blue});
        REQUIRE(bytes.size() == 8 * 4 + 2 * 4 * 2);
        CHECK(std::abs(byte_at(bytes, 10) - (16.0 + 219.0 * luma)) <= 1.0);
        CHECK(std::abs(byte_at(bytes, 32) - (128.0 + (b - luma) * 112.0 / 0.886)) <= 1.0);
        CHECK(std::abs(byte_at(bytes, 40) - (128.0 + (r - luma) * 112.0 / 0.701)) <= 1.0);
    }
}

TEST_CASE("a V4L2 camera gets even sides") {
    CHECK(recorded({7, 5}, {255, 255, 255}).size() == 8 * 6 + 2 * 4 * 3);
}

TEST_CASE("a V4L2 camera that does not exist names what to install") {
    const auto camera = open_v4l2_camera("/dev/no-camera", {8, 8}, frame_rate_fraction(60.0));
    REQUIRE_FALSE(camera);
    CHECK(camera.error().front().message ==
          "virtual camera '/dev/no-camera' not found. Install the package v4l2loopback-dkms, then "
          "run: modprobe v4l2loopback exclusive_caps=1");
}
