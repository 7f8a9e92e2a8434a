#pragma once

#include "ui/picture/picture_canvas.h"

#include <functional>

/// Over the picture, while the pen is in the hand: the keyframe before, thinly; the line that is
/// under way; the points that can be moved; the stroke that would be deleted. `screen` gives the
/// place on the screen of a pixel of the picture.
void draw_drawing_overlay(const Scene& scene, const CanvasInput& input,
                          const std::function<ImVec2(const PicturePixel&)>& screen);
