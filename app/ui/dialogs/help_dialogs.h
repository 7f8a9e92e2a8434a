#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

/// Version, licence, folders and the articles behind the looks.
void draw_about_dialog(const Scene& scene, Edits& edits);
