#pragma once

#include "graph/inspect/viewer.h"

/// The luminance, 0 (black) to 1 (white) in linear light, of a texel with these stored numbers as
/// the Viewer displays it. It decides whether text on it is black or white.
double displayed_luminance(const std::array<float, 4>& rgba, Format format,
                           const ViewOptions& options);
