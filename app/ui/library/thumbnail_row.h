#pragma once

#include "lab/views/view_image.h"
#include "lab/window/window_state.h"
#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

#include <optional>
#include <string>
#include <vector>

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

/// A list of thumbnail rows that fills the rest of its pane.
struct ThumbnailList {
    std::string name;              // of the child window
    std::vector<std::string> ids;  // of all rows
    std::string open;              // the id of the open row; may be none of them
};

/// Begins the child window of a list; end it with ImGui::EndChild(). While rows are added or
/// removed, the row under the pointer keeps its place. The list scrolls to the open row when
/// another one was opened and the pointer is elsewhere.
void begin_thumbnail_list(const ThumbnailList& list, ListAnchor ScrolledTo::*anchor,
                          const Scene& scene, Edits& edits);
