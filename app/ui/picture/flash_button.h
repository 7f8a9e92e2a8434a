#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

/// Flashes per second; red above the limit. Click to choose how flashes are handled.
void draw_flash_button(const Scene& scene, Edits& edits);
float flash_button_width(const Scene& scene);
