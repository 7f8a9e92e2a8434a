#pragma once

#include "ui/frame/scene.h"

class Edits;

/// The pinned points in a table: what every pass holds there.
void draw_pins_panel(const Scene& scene, Edits& edits);

/// Pins the pixel that was probed last when a view that was drawn last is clicked with Ctrl.
void pin_on_click(const Scene& scene, Edits& edits);

/// Their numbers where they lie in a view of a picture whose top left corner is `low`.
void draw_pin_marks(const Scene& scene, const ImVec2& low, Extent picture, const PictureView& view,
                    Extent room);
