#pragma once

#include "lab/window/parameter_listing.h"
#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

/// Starts the preview of one step of the pointed parameter.
void ask_for_step(const Pointed& pointed, bool is_up, Edits& edits);

/// Moves a running preview to the parameter under the pointer while U is held.
void follow_pointer(const Scene& scene, Edits& edits);

/// The preview as menu items; Escape ends it.
void draw_step_items(const std::string& parameter, Edits& edits);
