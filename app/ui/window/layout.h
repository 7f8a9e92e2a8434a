#pragma once

#include "lab/window/window_state.h"
#include "ui/frame/edits.h"
#include "ui/widgets/widgets.h"

/// Where each pane of the window is; one without a width or height is not shown.
struct Layout {
    Rect library;
    Rect transport;
    Rect picture;
    Rect strip;
    Rect bottom;
    Rect parameters;
    Rect inspector;
    Rect status;
};

/// The panes in a window whose usable part (below the menu) is `all`. The picture keeps at least a
/// third of the width and height, whatever the sizes that a person dragged.
Layout arrange_panes(const WindowState& window, const Rect& all, float scale);

/// The gaps between the panes, that can be dragged.
void draw_splitters(const Layout& layout, const WindowState& window, float scale, Edits& edits);
