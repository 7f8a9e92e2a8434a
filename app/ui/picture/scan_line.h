#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

#include <imgui/imgui.h>

/// Lets the mouse move the line of the waveform in a view of this size at the cursor: its ends, all
/// of it by its middle, or with Shift a new one. To be called before the picture, which would catch
/// the mouse; nothing while the waveform is not shown.
void drag_scan_line(const ImVec2& size, const Scene& scene, Edits& edits);
/// The line over the picture, in a view whose top left corner is `low`.
void draw_scan_line(const ImVec2& low, const ImVec2& size, const Scene& scene);
