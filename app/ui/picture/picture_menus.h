#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

/// The picture's size and its zoom, each a button with a menu behind it.
void draw_picture_menus(const Scene& scene, Edits& edits);
float picture_menus_width(const Scene& scene);

/// Of what lies in the picture's place: the picture, or the pass that is shown large.
Extent large_extent(const Scene& scene);

/// What it has of the view, in device pixels: a half of two side by side.
Extent large_room(const Scene& scene);

/// The choices behind the buttons, also for the menu bar.
void draw_size_items(const Scene& scene, Edits& edits);
void draw_zoom_items(const Scene& scene, Edits& edits);

/// "2×", "1/2×", "0.73×".
std::string zoom_text(double zoom);
