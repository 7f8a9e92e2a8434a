#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

/// How often the picture flashes a second; red beyond the limit. A click asks what is done about
/// it.
void draw_flash_button(const Scene& scene, Edits& edits);
float flash_button_width(const Scene& scene);
