#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

/// Runs the actions whose keys are pressed. While a text field is active, letters belong to it.
void run_shortcuts(const Scene& scene, Edits& edits);
