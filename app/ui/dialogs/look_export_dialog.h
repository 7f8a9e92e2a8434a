#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

/// The dialog that exports the look for other programs: what each target keeps and loses, then how
/// far the export differs from the picture.
void draw_look_export_dialog(const Scene& scene, Edits& edits);

/// Opens it, without the result of the previous export.
void export_look(const Scene& scene, Edits& edits);
