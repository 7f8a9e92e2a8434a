#pragma once

#include "ui/frame/scene.h"

class Edits;

/// A table of the pinned pixels with their value in every pass.
void draw_pins_panel(const Scene& scene, Edits& edits);

/// Ctrl+click on the view that was drawn last pins the probed pixel.
void pin_on_click(const Scene& scene, Edits& edits);

/// Marks the pins with their numbers in a view with top left corner `low`.
void draw_pin_marks(const Scene& scene, const ImVec2& low, Extent picture, const PictureView& view,
                    Extent room);
