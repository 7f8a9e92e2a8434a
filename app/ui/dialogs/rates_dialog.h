#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

/// Starts the comparison of several frame rates and shows the dialog.
void compare_rates(Edits& edits);

/// Shows the progress with a Cancel button, then the differences between the rates and their
/// location.
void draw_rates_dialog(const Scene& scene, Edits& edits);
