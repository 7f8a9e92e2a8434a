#pragma once

#include "ui/frame/scene.h"

class Edits;

/// How the inspected target's numbers are spread over the view: their histogram from black to white
/// with what they come to, and below it both ends, with the switches that mark numbers in the view.
void draw_inspector_levels(const Scene& scene, Edits& edits);
