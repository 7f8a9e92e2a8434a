#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

#include <filesystem>

/// Starts the export of the document to a film or an image sequence and shows its progress.
void export_frames(const std::filesystem::path& file, const Scene& scene, Edits& edits);

/// The duration and frame rate fields of the file dialog for an export.
void draw_export_numbers(const Scene& scene, Edits& edits);

void draw_export_dialog(const Scene& scene, Edits& edits);
