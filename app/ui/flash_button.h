#pragma once

#include "ui/edits.h"
#include "ui/scene.h"

/// How often the picture flashes a second; red beyond the limit. A click asks what is done about
/// it.
void draw_flash_button(const Scene& scene, Edits& edits);
float flash_button_width(const Scene& scene);
