#include "io/virtual_camera/virtual_camera.h"

#include "io/virtual_camera/pipewire_camera.h"
#include "io/virtual_camera/v4l2_camera.h"

namespace {
constexpr std::string_view pipewire_start = "pipewire:";
constexpr std::string_view v4l2_start = "v4l2:";
constexpr const char* usual_name = "Afterglow";
}  // namespace

bool is_virtual_camera(std::string_view text) {
    return text.starts_with(pipewire_start) || text.starts_with(v4l2_start);
}

Result<VirtualCameraSpec> parse_virtual_camera(std::string_view text) {
    using enum VirtualCameraSpec::Kind;
    if (text.starts_with(pipewire_start)) {
        const std::string_view name = text.substr(pipewire_start.size());
        return VirtualCameraSpec{pipewire, name.empty() ? usual_name : std::string(name)};
    }
    const std::string_view device =
        text.starts_with(v4l2_start) ? text.substr(v4l2_start.size()) : std::string_view();
    if (device.empty())
        return fail({{}, 0, "name a virtual camera as pipewire:NAME or v4l2:/dev/videoN"});
    return VirtualCameraSpec{v4l2, std::string(device)};
}

Result<std::unique_ptr<VirtualCamera>> open_virtual_camera(const VirtualCameraSpec& spec,
                                                           Extent extent, FrameRateFraction rate) {
    return spec.kind == VirtualCameraSpec::Kind::pipewire
               ? open_pipewire_camera(spec.name, extent, rate)
               : open_v4l2_camera(spec.name, extent, rate);
}

VirtualCameraSpec usual_virtual_camera() {
    if (const auto device = find_v4l2_camera())
        return {VirtualCameraSpec::Kind::v4l2, *device};
    return {VirtualCameraSpec::Kind::pipewire, usual_name};
}
