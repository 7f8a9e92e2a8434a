#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

#include <imgui/imgui.h>

/// Dragging of the waveform's line in a view of this size at the cursor. Its ends and its middle
/// are handles; Shift+drag draws a new line. Call it before drawing the picture, which would
/// capture the mouse. Does nothing while the waveform is hidden.
void drag_scan_line(const ImVec2& size, const Scene& scene, Edits& edits);
/// Draws the line over the picture, in a view with top left corner `low`.
void draw_scan_line(const ImVec2& low, const ImVec2& size, const Scene& scene);
