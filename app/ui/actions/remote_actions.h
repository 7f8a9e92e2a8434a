#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

/// Runs the action that OSC or MIDI asks for, or reports why it cannot run.
void run_requested_action(const Scene& scene, Edits& edits);
