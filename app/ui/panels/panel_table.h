#pragma once

#include "ui/frame/action.h"
#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

#include <span>
#include <vector>

/// The pane around a panel: it scrolls, is as large as its content, or the panel makes its own
/// panes.
enum class PanelFrame { scrolling, fixed, own };

/// A panel of the window. A new panel is one file and one row: its menu item, shortcut, palette
/// entry, tab, visibility and session entry derive from the row.
struct Panel {
    PanelId id;
    const char* title;  // of the menu item
    Chord chord;
    void (*draw)(const Scene& scene, Edits& edits);
    const char* tab = "";  // in the bottom pane
    PanelPlace place = PanelPlace::bottom;
    bool is_open = false;  // at the first start
    bool covers = false;   // the panel below it stays open
    Menu menu = Menu::view;
    PanelFrame frame = PanelFrame::scrolling;
    float min_height = 0.0f;          // of the bottom pane when it opens, px of layout; 0: as it is
    bool leaves_full_screen = false;  // when it opens
    bool needs_look = false;          // the menu item is disabled until a look is open
};

/// All panels, in the order of the menus.
std::span<const Panel> panels();
/// Their places.
std::vector<PanelKind> panel_kinds();
const Panel& panel_of(PanelId id);

/// Whether the menu item is checked.
bool is_chosen(const Panel& panel, const WindowState& window);
/// Shows the panel, or hides it if it is shown.
void toggle(const Panel& panel, WindowState& window);
