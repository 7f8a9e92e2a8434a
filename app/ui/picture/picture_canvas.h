#pragma once

#include "lab/views/views.h"
#include "lab/window/window_state.h"
#include "model/look/orbit.h"
#include "ui/frame/scene.h"

#include <imgui/imgui.h>

#include <functional>
#include <optional>

/// A picture in its view, that the wheel zooms and a drag moves (with the middle button, where the
/// left one is the look's). With an orbit the left button
/// turns the object, the right one moves the camera, and the wheel with Ctrl brings it nearer; the
/// middle one still moves the view.
struct PictureCanvas {
    const char* id;
    Views::Image image;  // as it lies in the view
    Extent picture;      // the whole of it, px
    PictureView view;
    ImVec2 size;  // of the view, coordinates of the window
    bool has_orbit = false;
    bool has_pen = false;    // the left button draws, the right one is handed on
    bool has_press = false;  // the left button is the look's
};

/// What a person did to it.
struct CanvasInput {
    std::optional<PictureView> moved;
    std::optional<std::array<double, 2>> hovered;  // pixel of the picture, from the top left
    std::function<Orbit(const Orbit&)> turned;     // empty: not
    bool is_turn_finished = false;
    std::optional<std::array<double, 2>> pen_down;  // pixels, as hovered
    std::vector<std::array<double, 2>> pen_path;    // while the left button is held
    bool is_pen_up = false;
    std::optional<std::array<double, 2>> other_button;  // pressed at this pixel
};

/// Draws it at the cursor. The picture is zoomed about the pointer.
CanvasInput draw_picture_canvas(const PictureCanvas& canvas, const Scene& scene);
