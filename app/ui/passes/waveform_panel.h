#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

/// Plots the values along a line over the picture.
void draw_waveform_panel(const Scene& scene, Edits& edits);
