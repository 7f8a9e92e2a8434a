#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

/// Runs the actions of pressed keys. An active text field gets the letters instead.
void run_shortcuts(const Scene& scene, Edits& edits);

/// Runs an action. If it discarded something, a notice offers Undo.
void act_with_undo_notice(const Action& action, const Scene& scene, Edits& edits);
