#pragma once

#include "lab/window/window_state.h"
#include "model/look/parameter.h"
#include "ui/frame/edits.h"

#include <vector>

/// Whether a person just asked to see one of these parameters.
bool is_to_be_shown(const std::vector<const Parameter*>& parameters, const WindowState& window);

/// Scrolls the present child window to a parameter that a person asked to see, and tints it until
/// the next click (of a vector the part that keys turn). To be called behind the parameter's
/// controls; they begin at `top`.
void show_if_revealed(const Parameter& parameter, float top, const WindowState& window,
                      Edits& edits);
