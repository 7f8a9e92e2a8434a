#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

/// Every pass in order: what it draws now, its name, size, format and time. A click inspects it.
void draw_pass_strip(const Scene& scene, Edits& edits);
