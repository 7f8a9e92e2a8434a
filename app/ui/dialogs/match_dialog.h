#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

#include <filesystem>

/// Matches the open look to a photo of a tube: photo, corners and source, then the match at work,
/// then its numbers.
void draw_match_dialog(const Scene& scene, Edits& edits);

/// Opens a file that was dropped on the window: as the photo while this dialog is open.
void open_dropped(const std::filesystem::path& file, const Scene& scene, Edits& edits);
