#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"
#include "ui/parameters/parameter_control.h"

/// Menu items of a parameter: shows its MIDI controller, learns one or removes it. Draws nothing
/// for a parameter that MIDI cannot control.
void draw_midi_items(const ParameterEntry& entry, Edits& edits);

/// The MIDI section of the remote control dialog: devices and all bindings.
void draw_midi_settings(const Scene& scene, Edits& edits);
