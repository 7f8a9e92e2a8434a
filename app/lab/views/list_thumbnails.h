#pragma once

#include "lab/views/file_thumbnail.h"
#include "lab/views/history_thumbnails.h"
#include "lab/views/look_thumbnails.h"
#include "lab/views/preset_thumbnails.h"
#include "lab/views/stash_thumbnails.h"
#include "lab/window/window_state.h"

/// The pictures in the lists of looks, presets, history, unsaved changes and files.
struct ListThumbnails {
    HistoryThumbnails history;
    PresetThumbnails presets;
    StashThumbnails kept;
    LookThumbnails looks;
    bool has_time = false;    // frames leave time to draw pictures of looks and presets
    FileThumbnail file = {};  // selected in the file dialog

    /// Call it after Views::update().
    void update(const Lab& lab, Views& views, const WindowState& window, const LibraryView& library,
                double wall_seconds);
};
