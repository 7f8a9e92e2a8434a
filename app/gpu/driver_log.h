#pragma once

#include "base/diagnostic.h"
#include "model/look/look.h"

#include <string_view>

namespace gpu {

/// What a driver said about a stage that it refused, each line at the place where the author wrote
/// it. Reads Mesa's "0:12(5): error: ", NVIDIA's "0(12) : error C1008: " and the "ERROR: 0:12: " of
/// AMD, Intel and macOS. A log without any place becomes one diagnostic on the stage's file.
Diagnostics parse_driver_log(std::string_view log, const Stage& stage);

}  // namespace gpu
