#pragma once

#include "lab/window/open_panels.h"
#include "lab/window/pane_sizes.h"

/// The panels of the window and the sizes of their places.
struct WindowLayout {
    OpenPanels panels;
    PaneSizes sizes;
    bool is_picture_only = false;  // full screen

    bool operator==(const WindowLayout&) const = default;
    bool sees(PanelId panel) const { return !is_picture_only && panels.shows(panel); }
    /// Shows a panel, and leaves full screen.
    void reveal(PanelId panel) {
        panels.show(panel);
        is_picture_only = false;
    }
};
