#pragma once

#include "lab/lab.h"
#include "lab/window/window_state.h"

#include <filesystem>

/// Writes the present picture as a PNG (which also carries the preset) or an EXR, as the name says,
/// and tells how that went. A name without an ending becomes a PNG.
void save_snapshot(Lab& lab, std::filesystem::path file);

/// Writes what the view looks into and tells how that went: an EXR holds its numbers as they
/// are stored, a PNG what the view shows of them, texel by texel. A name without an ending becomes
/// an EXR.
void save_target(Lab& lab, const PassView& view, std::filesystem::path file);
