#pragma once

#include <filesystem>

/// Removes the oldest files of a folder with cached thumbnails; the 1000 most recent ones stay.
void forget_old(const std::filesystem::path& folder);
