#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

#include <filesystem>
#include <optional>

/// What the user clicked next to the list of a file dialog.
struct PlaceClick {
    std::optional<std::filesystem::path> folder;
    std::optional<std::filesystem::path> file;  // a recent one, to open
};

/// Draws the folders that the dialog offers and, for opening, the recent files.
PlaceClick draw_file_places(const FileRules& rules, float height, const Scene& scene, Edits& edits);

/// The places for a dialog of this scene: those of the desktop, and the folders of looks.
std::vector<Place> dialog_places(const Scene& scene);

/// Draws the listed folder as a row of buttons, one for each folder of its path. Returns the
/// clicked one. `width`: of the row.
std::optional<std::filesystem::path> draw_folder_path(const std::filesystem::path& folder,
                                                      float width, Edits& edits);
