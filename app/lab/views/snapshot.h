#pragma once

#include "lab/lab.h"
#include "lab/window/pass_view.h"

#include <filesystem>

/// Saves the current picture as a PNG with the preset, or as an EXR, and reports the result. A name
/// without extension gets .png.
void save_snapshot(Lab& lab, std::filesystem::path file);

/// Saves the texture inspected by `view` and reports the result. An EXR has the stored values, a
/// PNG the displayed ones, in full resolution. A name without extension gets .exr.
void save_target(Lab& lab, const PassView& view, std::filesystem::path file);
