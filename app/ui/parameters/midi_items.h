#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"
#include "ui/parameters/parameter_control.h"

/// Menu items of a parameter: copies its OSC address, and learns or removes its MIDI controller, if
/// MIDI can control it.
void draw_midi_items(const ParameterEntry& entry, Edits& edits);

/// The MIDI section of the remote control dialog: devices and all bindings.
void draw_midi_settings(const Scene& scene, Edits& edits);
