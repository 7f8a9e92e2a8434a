#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

#include <filesystem>

/// Begins to draw the document into a film or a sequence, and shows how far it is.
void export_frames(const std::filesystem::path& file, const Scene& scene, Edits& edits);

/// How much is exported, within the dialog that asks where to.
void draw_export_numbers(const Scene& scene, Edits& edits);

void draw_export_dialog(const Scene& scene, Edits& edits);
