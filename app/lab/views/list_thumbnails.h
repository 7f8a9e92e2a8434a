#pragma once

#include "lab/views/history_thumbnails.h"
#include "lab/views/preset_thumbnails.h"
#include "lab/views/stash_thumbnails.h"
#include "lab/window/window_state.h"

/// The pictures in the lists of history, presets and unsaved changes.
struct ListThumbnails {
    HistoryThumbnails history;
    PresetThumbnails presets;
    StashThumbnails kept;

    /// Call it after Views::update().
    void update(const Lab& lab, Views& views, const WindowState& window, double wall_seconds);
};
