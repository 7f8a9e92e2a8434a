#pragma once

#include "lab/views/views.h"
#include "lab/window/picture_view.h"
#include "model/look/orbit.h"
#include "ui/frame/scene.h"

#include <imgui/imgui.h>

#include <functional>
#include <optional>

/// A view of a picture. The wheel zooms, dragging pans. The middle button always pans; the left one
/// only if neither look nor pen uses it. With an orbit, the left button rotates the object, the
/// right one moves the camera, and Ctrl+wheel changes the distance.
struct PictureCanvas {
    const char* id;
    ViewImage image;  // the visible part
    Extent picture;   // the whole picture, px
    PictureView view;
    ImVec2 size;  // of the view, window coordinates
    bool has_orbit = false;
    bool has_pen = false;    // left button draws; right clicks are reported
    bool has_press = false;  // the look reads the left button
};

/// The input to the canvas in one frame.
struct CanvasInput {
    std::optional<PictureView> moved;
    std::optional<std::array<double, 2>> hovered;  // pixel, from the top left
    std::function<Orbit(const Orbit&)> orbit;      // empty: unchanged
    bool is_turn_finished = false;
    std::optional<std::array<double, 2>> pen_down;  // pixel, as hovered
    std::vector<std::array<double, 2>> pen_path;    // while the left button is held
    bool is_pen_up = false;
    std::optional<std::array<double, 2>> right_click;  // right click at this pixel
};

/// Draws the picture at the cursor. Zooming is centred on the pointer.
CanvasInput draw_picture_canvas(const PictureCanvas& canvas, const Scene& scene);
