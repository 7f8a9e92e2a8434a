#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

#include <filesystem>

/// Opens or saves the file that was chosen in the open dialog. The dialog closes if that succeeds,
/// otherwise it shows why not.
void finish_file_dialog(const std::filesystem::path& file, const Scene& scene, Edits& edits);
