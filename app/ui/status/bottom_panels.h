#pragma once

#include "ui/frame/action.h"
#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

#include <span>

/// A panel of the bottom pane. A new panel is one file and one row: its tab, menu item, shortcut,
/// palette entry and visibility derive from the row.
struct BottomPanel {
    BottomPart part;
    const char* tab;
    ActionId action;
    const char* title;  // of the menu item
    Chord chord;
    void (*draw)(const Scene& scene, Edits& edits);
    float least_height = 0.0f;  // of the pane when it opens, px of layout; 0: as it is
    bool needs_look = false;    // the menu item is disabled until a look is open
};

/// In the order of BottomPart.
std::span<const BottomPanel> bottom_panels();

/// Whether the pane shows the panel, also while the window is in full screen.
bool is_chosen(const BottomPanel& panel, const WindowState& window);
/// Shows the panel, or closes the pane if it already shows the panel.
void toggle(const BottomPanel& panel, WindowState& window);
