#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

#include <imgui/imgui.h>

/// The time axis of the picture: the waveform of both channels, the loop region and the playing
/// position. Drag in the waveform to scrub, in the ruler to set a region; the wheel zooms. `mark`:
/// its name for scripts, also its id. `size` in window coordinates.
void draw_timeline(const char* mark, const ImVec2& size, const Scene& scene, Edits& edits);

/// The bottom panel with a large timeline.
void draw_timeline_panel(const Scene& scene, Edits& edits);

/// Seeks relative to the playing position, within the sound.
void seek_by_seconds(double seconds, const Scene& scene, Edits& edits);
