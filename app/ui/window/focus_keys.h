#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

/// The name of the ImGui window that holds all panes.
inline constexpr const char* main_window_name = "Afterglow";

/// The keyboard focus: Tab and Shift+Tab move from control to control, Ctrl+Tab and Ctrl+Shift+Tab
/// from pane to pane, arrow keys in their direction. Enter activates a control. Escape or a click
/// ends it. In a dialog it stays among the dialog's controls. Call it before the main window.
void follow_focus_keys(const Scene& scene, Edits& edits);

/// Call it at the start of each pane, inside it: Ctrl+Tab may have chosen this pane.
void begin_pane_focus(const Scene& scene);

/// Draws the frame around the focused control, and marks it "focus". Call it after all panes and
/// dialogs.
void draw_focus_frame(const Scene& scene, Edits& edits);
