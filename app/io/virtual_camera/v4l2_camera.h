#pragma once

#include "io/virtual_camera/virtual_camera.h"

#include <optional>
#include <vector>

/// A virtual camera of the kernel, such as v4l2loopback makes. ffmpeg writes to it.
Result<std::unique_ptr<VirtualCamera>> open_v4l2_camera(const std::string& device, Extent extent,
                                                        FrameRateFraction rate);

/// The first such device of this machine.
std::optional<std::string> find_v4l2_camera();

/// The command that reads the pictures of a camera from its standard input and writes them to
/// `output`, a format and a file: planar YUV 4:2:0 of even sides, ITU-R BT.601, as cameras send.
std::vector<std::string> camera_command(Extent extent, FrameRateFraction rate,
                                        const std::vector<std::string>& output);
