#pragma once

#include "base/diagnostic.h"

#include <string>
#include <vector>

/// The titles of the windows of other programs on the display of $DISPLAY, the topmost first.
/// Errors have no file.
Result<std::vector<std::string>> list_windows();

/// The video devices of this machine, such as "/dev/video0".
std::vector<std::string> list_cameras();
