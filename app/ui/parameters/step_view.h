#pragma once

#include "lab/window/window_state.h"
#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

/// Shows what a step of the pointed parameter changes, until it is ended.
void ask_for_step(const Pointed& pointed, bool is_up, Edits& edits);

/// While that is shown and the key is held, it is of the parameter that the pointer has moved to.
void follow_pointer(const Scene& scene, Edits& edits);

/// The same as lines of a menu; Escape ends it then.
void draw_step_items(const std::string& parameter, Edits& edits);
