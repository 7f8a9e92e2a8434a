#pragma once

#include "ui/frame/action.h"
#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

#include <span>

/// The pane around a panel: it scrolls, is as large as its content, or the panel makes its own
/// panes.
enum class PanelFrame { scrolling, fixed, own };

/// A panel of the window. A new panel is one file and one row: its menu item, shortcut, palette
/// entry, tab and visibility derive from the row. Its place and what is stored is in its PanelKind.
struct Panel {
    PanelId id;
    const char* title;  // of the menu item
    Chord chord;
    void (*draw)(const Scene& scene, Edits& edits);
    const char* tab = "";  // in the bottom pane
    Menu menu = Menu::view;
    PanelFrame frame = PanelFrame::scrolling;
    float least_height = 0.0f;        // of the bottom pane when it opens, px of layout; 0: as it is
    bool leaves_full_screen = false;  // when it opens
    bool needs_look = false;          // the menu item is disabled until a look is open
};

/// One for each PanelId, in the order of the menus.
std::span<const Panel> panels();
const Panel& panel_of(PanelId id);

/// Whether the menu item is checked.
bool is_chosen(const Panel& panel, const WindowState& window);
/// Shows the panel, or hides it if it is shown.
void toggle(const Panel& panel, WindowState& window);
