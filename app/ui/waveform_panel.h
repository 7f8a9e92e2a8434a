#pragma once

#include "ui/edits.h"
#include "ui/scene.h"

/// The numbers along a line over the picture, plotted from its start to its end.
void draw_waveform_panel(const Scene& scene, Edits& edits);
