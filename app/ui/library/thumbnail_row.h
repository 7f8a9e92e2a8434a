#pragma once

#include "lab/views/view_image.h"
#include "lab/window/window_state.h"
#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

#include <optional>
#include <string>

/// A row of a list: a small picture and a name.
struct ThumbnailRow {
    std::string label;
    std::string about;  // tooltip
    ViewImage image;
    bool is_open = false;
    bool is_modified = false;
    std::optional<bool> star = {};  // nullopt: it can have no star
    std::string star_mark = {};     // of the star, for window tests
};

/// What was clicked in a row.
struct RowClick {
    bool is_row = false;
    bool is_star = false;
};

/// The height of each row, without a gap.
float thumbnail_row_height();
RowClick draw_thumbnail_row(const ThumbnailRow& row, const Scene& scene, Edits& edits);

/// Keeps the row under the pointer in place while rows above it are added or removed, and scrolls
/// to the open row when another one was opened. Call it in the child window of the list, before its
/// rows. `ids` are those of all rows. Returns the height to add below the last row, so that the
/// list can scroll far enough.
float hold_rows(const std::vector<std::string>& ids, const std::string& open,
                ListAnchor ScrolledTo::*anchor, const Scene& scene, Edits& edits);
