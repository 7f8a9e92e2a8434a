#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

/// The last rejected messages of OSC and MIDI.
void draw_remote_panel(const Scene& scene, Edits& edits);
