#pragma once

#include "lab/window/file_dialog_kind.h"
#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

/// Shown while the desktop's file dialog is open: it can be cancelled, or replaced by the program's
/// own.
void draw_desktop_dialog(const Scene& scene, Edits& edits);

/// A button of the program's own file dialog that changes to the desktop's, if it has one. The next
/// item continues its line.
void draw_desktop_switch(const Scene& scene, Edits& edits);
