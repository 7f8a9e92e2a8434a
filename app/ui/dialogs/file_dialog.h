#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

/// Dialog for opening and saving files: the entries of a folder, its path and a name.
void draw_file_dialog(const Scene& scene, Edits& edits);
