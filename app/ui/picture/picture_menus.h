#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

/// Buttons with menus for render size and zoom.
void draw_picture_menus(const Scene& scene, Edits& edits);
float picture_menus_width(const Scene& scene);

/// The size of the picture, or of the pass that replaces it.
Extent large_extent(const Scene& scene);

/// Its part of the view, in device pixels: half the view for side-by-side comparison.
Extent main_pane_size(const Scene& scene);

/// The items of both menus, also for the menu bar.
void draw_size_items(const Scene& scene, Edits& edits);
void draw_zoom_items(const Scene& scene, Edits& edits);

/// "2×", "1/2×", "0.73×".
std::string zoom_text(double zoom);
