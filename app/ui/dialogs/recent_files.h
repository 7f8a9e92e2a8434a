#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

/// The recently opened files with these endings that still exist. Empty `extensions`: all files.
std::vector<std::filesystem::path> recent_files(const Scene& scene,
                                                const std::vector<std::string>& extensions);

/// Draws the list in the available width; returns the clicked file.
std::optional<std::filesystem::path> draw_recent_files(
    const std::vector<std::filesystem::path>& files, Edits& edits);
