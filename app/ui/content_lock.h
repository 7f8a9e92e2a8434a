#pragma once

#include "ui/edits.h"
#include "ui/scene.h"

/// The heading of the signal or source with the button that locks it.
void draw_content_heading(const std::string& text, const Scene& scene, Edits& edits);
