#pragma once

#include "graph/inspect/viewer.h"

/// The luminance, 0 black .. 1 white (linear light), of a texel with these stored numbers as the
/// Viewer shows it: what tells whether black or white letters are read on it.
double seen_luminance(const std::array<float, 4>& rgba, Format format, const ViewOptions& options);
