#pragma once

#include "base/diagnostic.h"
#include "model/look/look.h"

#include <string_view>

namespace gpu {

/// The driver's messages about a rejected stage, mapped to the original source lines. Parses Mesa's
/// "0:12(5): error: ", NVIDIA's "0(12) : error C1008: " and the "ERROR: 0:12: " of AMD, Intel and
/// macOS. A log without errors in these formats adds one diagnostic on the stage's file.
Diagnostics parse_driver_log(std::string_view log, const Stage& stage);

}  // namespace gpu
