#pragma once

#include "gpu/input_event.h"
#include "lab/lab.h"
#include "lab/library/library_view.h"
#include "lab/rendering/pace.h"
#include "lab/views/list_pictures.h"
#include "lab/views/views.h"
#include "lab/window/window_state.h"
#include "ui/frame/action.h"
#include "ui/frame/fonts.h"

/// The read-only data of a frame for the panels.
struct Scene {
    const Lab& lab;
    const WindowState& window;
    const Views& views;
    const ListPictures& pictures;
    const LibraryView& library_view;
    const Pace& pace;
    std::size_t output_monitor;     // of the output window, or where it would open
    bool is_behind_output = false;  // the output window covers this one
    const Fonts& fonts;
    const ActionTable& actions;
    long frame_number = 0;                             // number of window frames so far
    bool is_behind = false;                            // input events wait for later frames
    float scale = 1.0f;                                // window coordinates per layout pixel
    float density = 1.0f;                              // device pixels per window coordinate
    std::vector<gpu::PointerEvent> pointer_path = {};  // since the last frame
    double panel_milliseconds = 0.0;                   // CPU time of the last frame's panels
};

/// The size of an area of the window in device pixels.
inline Extent device_pixels(const Scene& scene, float width, float height) {
    return {static_cast<int>(width * scene.density), static_cast<int>(height * scene.density)};
}
