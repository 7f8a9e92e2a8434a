#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

/// The chosen pass as it was told: of every sampler what it reads and how, and the built-in
/// uniforms with their numbers. A click on a pass that is read chooses that one.
void draw_pass_inputs(const Scene& scene, Edits& edits);
