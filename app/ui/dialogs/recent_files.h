#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

/// The files that were opened lately and are still there.
std::vector<std::filesystem::path> recent_files(const Scene& scene,
                                                const std::vector<std::string>& endings);

/// Lists them in what room there is; gives the one that was clicked.
std::optional<std::filesystem::path> draw_recent_files(
    const std::vector<std::filesystem::path>& files, Edits& edits);
