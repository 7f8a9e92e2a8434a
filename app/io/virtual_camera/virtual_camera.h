#pragma once

#include "base/diagnostic.h"
#include "model/look/extent.h"
#include "model/picture/frame_rate_fraction.h"

#include <memory>
#include <optional>
#include <string>
#include <string_view>

/// A camera for other programs whose pictures come from this program. Used by one thread.
class VirtualCamera {
public:
    virtual ~VirtualCamera() = default;

    /// Whether a program may see its pictures now. Errors have no file: the camera has ended. Open
    /// it again.
    virtual Result<bool> is_watched() = 0;
    /// Shows a picture: RGB with 8 bits per channel, display-encoded, row 0 at the top. Errors as
    /// in is_watched().
    virtual Result<void> show(std::string_view rgb) = 0;
    /// Waits until all pictures have been sent. Errors as in is_watched().
    virtual Result<void> finish() { return {}; }
};

/// Where the pictures go: "pipewire:NAME" or "v4l2:/dev/videoN".
struct VirtualCameraSpec {
    enum class Kind { pipewire, v4l2 };
    Kind kind = Kind::pipewire;
    std::string name;  // a node of PipeWire, or a device
};

/// Whether the text begins like the name of a virtual camera.
bool is_virtual_camera(std::string_view text);
/// Errors have no file.
Result<VirtualCameraSpec> parse_virtual_camera(std::string_view text);
/// Opens a camera whose pictures have this size and rate. Errors have no file and name what to
/// install.
Result<std::unique_ptr<VirtualCamera>> open_virtual_camera(const VirtualCameraSpec& spec,
                                                           Extent extent, FrameRateFraction rate);
/// The camera that most programs can read here: the first virtual V4L2 device, otherwise
/// "pipewire:Afterglow".
VirtualCameraSpec usual_virtual_camera();
