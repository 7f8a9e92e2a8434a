#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"
#include "ui/parameters/parameter_control.h"

/// In the menu of a parameter: which controller of a MIDI device turns it, to learn one, and to let
/// it go. Nothing for what no knob can turn.
void draw_midi_items(const Knob& knob, Edits& edits);

/// In the dialog about remote control: devices, and every controller that is bound.
void draw_midi_settings(const Scene& scene, Edits& edits);
