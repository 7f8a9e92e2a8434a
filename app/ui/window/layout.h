#pragma once

#include "lab/window/window_layout.h"
#include "ui/frame/edits.h"
#include "ui/widgets/widgets.h"

#include <map>

/// The positions of the panes; a pane without width or height is hidden.
struct Layout {
    Rect transport;
    Rect picture;
    Rect status;
    std::map<PanelPlace, Rect> panels = {};  // of the places that show a panel
};

/// Arranges the panes in the area `all` below the menu. The picture keeps at least a third of the
/// width and height, whatever sizes the user has dragged.
Layout arrange_panes(const WindowLayout& window, const Rect& all, float scale);

/// The draggable gaps between the panes.
void draw_splitters(const Layout& layout, float scale, Edits& edits);
