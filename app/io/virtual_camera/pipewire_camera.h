#pragma once

#include "io/virtual_camera/virtual_camera.h"

/// A camera that programs find under `name` through PipeWire.
Result<std::unique_ptr<VirtualCamera>> open_pipewire_camera(const std::string& name, Extent extent,
                                                            FrameRateFraction rate);
