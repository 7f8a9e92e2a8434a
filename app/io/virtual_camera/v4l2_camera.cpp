#include "io/virtual_camera/v4l2_camera.h"

#include "io/capture/capture_list.h"
#include "io/system/child_process.h"
#include "io/system/descriptor.h"
#include "io/video/video_input.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <fcntl.h>
#include <filesystem>
#include <linux/videodev2.h>
#include <sys/ioctl.h>

namespace {
Descriptor opened(const std::string& device) {
    return Descriptor(::open(device.c_str(), O_RDWR | O_CLOEXEC | O_NONBLOCK));
}

// Whether programs can write pictures to the device.
bool takes_pictures(const std::string& device) {
    const Descriptor file = opened(device);
    v4l2_capability can{};
    if (!file.is_open() || ::ioctl(file.get(), VIDIOC_QUERYCAP, &can) != 0)
        return false;
    const bool is_per_node = (can.capabilities & V4L2_CAP_DEVICE_CAPS) != 0;
    return ((is_per_node ? can.device_caps : can.capabilities) & V4L2_CAP_VIDEO_OUTPUT) != 0;
}

bool is_forbidden(const std::string& device) {
    return !opened(device).is_open() && errno == EACCES;
}

class V4l2Camera final : public VirtualCamera {
public:
    explicit V4l2Camera(ChildProcess process) : m_process(std::move(process)) {}

    // A loopback device does not tell.
    Result<bool> is_watched() override { return true; }

    Result<void> show(std::string_view rgb) override {
        return m_process.feed(0, rgb) ? Result<void>() : finish();
    }

    Result<void> finish() override {
        m_process.end_input(0);
        if (m_process.finish())
            return {};
        const std::string complaint = m_process.complaint();
        return fail({{},
                     0,
                     fmt::format("the virtual camera has ended: {}. Open it again.",
                                 complaint.empty() ? m_process.fault() : complaint)});
    }

private:
    ChildProcess m_process;
};
}  // namespace

std::vector<std::string> camera_command(Extent extent, FrameRateFraction rate,
                                        const std::vector<std::string>& output) {
    std::vector<std::string> command{"ffmpeg",
                                     "-v",
                                     "error",
                                     "-f",
                                     "rawvideo",
                                     "-pixel_format",
                                     "rgb24",
                                     "-video_size",
                                     fmt::format("{}x{}", extent.width, extent.height),
                                     "-framerate",
                                     rate.text('/'),
                                     "-i",
                                     "pipe:0",
                                     "-vf",
                                     "pad=ceil(iw/2)*2:ceil(ih/2)*2",
                                     "-sws_flags",
                                     "bicubic+accurate_rnd+full_chroma_int",
                                     "-pix_fmt",
                                     "yuv420p",
                                     "-c:v",
                                     "rawvideo",
                                     "-f"};
    command.insert(command.end(), output.begin(), output.end());
    return command;
}

Result<std::unique_ptr<VirtualCamera>> open_v4l2_camera(const std::string& device, Extent extent,
                                                        FrameRateFraction rate) {
    std::error_code error;
    if (!std::filesystem::exists(device, error))
        return fail({{},
                     0,
                     fmt::format("virtual camera '{}' not found. Install the package "
                                 "v4l2loopback-dkms, then run: modprobe v4l2loopback "
                                 "exclusive_caps=1",
                                 device)});
    if (is_forbidden(device))
        return fail({{},
                     0,
                     fmt::format("no permission to open '{}'. Add yourself to the group video, and "
                                 "log in again.",
                                 device)});
    if (!takes_pictures(device))
        return fail({{},
                     0,
                     fmt::format("'{}' is not a free virtual camera. Choose another device, or "
                                 "close the program that sends to it.",
                                 device)});
    auto process =
        ChildProcess::start(camera_command(extent, rate, {"v4l2", device}), {.inputs = 1});
    if (!process)
        return without_ffmpeg({}, process.error());
    constexpr double longest_stall = 5.0;  // s
    process->set_timeout(longest_stall);
    return std::make_unique<V4l2Camera>(std::move(*process));
}

std::optional<std::string> find_v4l2_camera() {
    const std::vector<std::string> devices = list_cameras();
    const auto found = std::ranges::find_if(devices, takes_pictures);
    return found == devices.end() ? std::nullopt : std::optional(*found);
}
