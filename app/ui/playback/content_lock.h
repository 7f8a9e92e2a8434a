#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

/// The heading of the signal or source, with its lock button.
void draw_content_heading(const std::string& text, const Scene& scene, Edits& edits);
