#pragma once

#include "lab/drawing/beam_mapping.h"
#include "ui/picture/picture_canvas.h"

#include <functional>

/// Drawn over the picture while the pen is active: the previous keyframe, the open line, the
/// movable points, and the stroke that would be deleted. `screen` maps a pixel of the picture to
/// the screen.
void draw_drawing_overlay(const Scene& scene, const CanvasInput& input,
                          const std::function<ImVec2(const PicturePixel&)>& screen);
