#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

/// The input of the open look: the kind of signal and its settings, or the source picture. Also the
/// controls of the sound, if any.
void draw_signal_panel(const Scene& scene, Edits& edits);
