#pragma once

#include "ui/frame/scene.h"
#include "ui/parameters/parameter_control.h"

/// The look along the range of a slider, or over the grid of two; a click takes the values.
void draw_sheet_panel(const Scene& scene, Edits& edits);

/// Lines of a parameter's menu: it becomes what a filmstrip runs along, or goes down a sheet.
void draw_sheet_items(const Knob& knob, Edits& edits);

/// Nothing is drawn for a sheet that nobody sees.
void leave_hidden_sheet(const Scene& scene, Edits& edits);
