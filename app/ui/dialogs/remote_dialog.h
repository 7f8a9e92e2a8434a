#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

/// Settings and status of remote control by OSC and MIDI.
void draw_remote_dialog(const Scene& scene, Edits& edits);
