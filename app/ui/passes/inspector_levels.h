#pragma once

#include "ui/frame/scene.h"

class Edits;

/// Histogram of the inspected target from black to white, with statistics. Below are both ends and
/// the switches that mark values in the view.
void draw_inspector_levels(const Scene& scene, Edits& edits);
