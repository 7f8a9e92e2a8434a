#pragma once

#include "lab/views/history_pictures.h"
#include "lab/views/kept_pictures.h"
#include "lab/views/preset_pictures.h"
#include "lab/window/window_state.h"

/// The pictures in the lists of history, presets and unsaved changes.
struct ListPictures {
    HistoryPictures history;
    PresetPictures presets;
    KeptPictures kept;

    /// Call it after Views::update().
    void update(const Lab& lab, Views& views, const WindowState& window, double wall_seconds);
};
