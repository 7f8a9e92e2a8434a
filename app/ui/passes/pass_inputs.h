#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

/// The inputs of the inspected pass: for each sampler its input and settings, and the values of the
/// built-in uniforms. Click a pass that is read to inspect it.
void draw_pass_inputs(const Scene& scene, Edits& edits);
