#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

/// Asks for the name of a new pass after the one in Dialog::subject.
void draw_add_pass_dialog(const Scene& scene, Edits& edits);
