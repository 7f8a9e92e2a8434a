#pragma once

#include "ui/frame/scene.h"
#include "ui/parameters/parameter_control.h"

/// The look with several values of one parameter, or all combinations of two. Click a picture to
/// apply its values.
void draw_sheet_panel(const Scene& scene, Edits& edits);

/// Menu item of a parameter: shows a filmstrip of it.
void draw_sheet_items(const ParameterEntry& entry, Edits& edits);

/// Stops drawing a sheet that is not visible.
void leave_hidden_sheet(const Scene& scene, Edits& edits);
