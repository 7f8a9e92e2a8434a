#pragma once

#include "lab/window/window_state.h"
#include "ui/frame/edits.h"
#include "ui/widgets/widgets.h"

/// The positions of the panes; a pane without width or height is hidden.
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

/// Arranges the panes in the area `all` below the menu. The picture keeps at least a third of the
/// width and height, whatever sizes the user has dragged.
Layout arrange_panes(const WindowState& window, const Rect& all, float scale);

/// The draggable gaps between the panes.
void draw_splitters(const Layout& layout, const WindowState& window, float scale, Edits& edits);
