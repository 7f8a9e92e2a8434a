#pragma once

#include "lab/lab.h"

#include <filesystem>

/// Writes the present picture as a PNG (which also carries the preset) or an EXR, as the name says,
/// and tells how that went. A name without an ending becomes a PNG.
void save_snapshot(Lab& lab, std::filesystem::path file);
