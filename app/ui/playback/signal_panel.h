#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

/// What drives the open look: the kind of signal and its settings, or the source picture; and the
/// sound, where there is one.
void draw_signal_panel(const Scene& scene, Edits& edits);
