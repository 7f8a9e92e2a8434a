#pragma once

#include "gpu/input_event.h"
#include "lab/files/folder_reader.h"
#include "lab/frame/frame_loop.h"
#include "lab/lab_parts.h"
#include "lab/library/library_view.h"
#include "lab/rendering/pace.h"
#include "lab/views/list_thumbnails.h"
#include "lab/views/views.h"
#include "lab/window/window_state.h"
#include "ui/frame/action.h"
#include "ui/frame/fonts.h"

/// One frame of the panels.
struct FrameInfo {
    long number = 0;                                   // from 1
    bool is_behind = false;                            // input events wait for later frames
    std::vector<gpu::PointerEvent> pointer_path = {};  // since the last frame
    double panel_milliseconds = 0.0;                   // CPU time of the last frame's panels
};

/// The read-only data of a frame for the panels.
struct Scene {
    const LabParts& lab;
    const WindowState& window;
    const Views& views;
    const ListThumbnails& pictures;
    const LibraryView& library_view;
    const FolderReader& folders;  // of the file dialog
    const Roots& roots;
    const Pace& pace;
    const ActionTable& actions;
    const Fonts& fonts;
    FrameInfo frame;
    std::size_t output_monitor = 0;  // of the output window, or where it would open
    bool is_behind_output = false;   // the output window covers this one
    float scale = 1.0f;              // window coordinates per layout pixel
    float density = 1.0f;            // device pixels per window coordinate
};

/// The size of an area of the window in device pixels.
inline Extent device_pixels(const Scene& scene, float width, float height) {
    return {static_cast<int>(width * scene.density), static_cast<int>(height * scene.density)};
}
