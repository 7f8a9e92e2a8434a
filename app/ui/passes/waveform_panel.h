#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

/// The numbers along a line over the picture, plotted from its start to its end.
void draw_waveform_panel(const Scene& scene, Edits& edits);
