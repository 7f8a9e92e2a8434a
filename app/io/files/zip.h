#pragma once

#include "base/diagnostic.h"

#include <filesystem>

/// Writes all files of a folder to a ZIP file, with a fixed date, so that the same files give the
/// same bytes. The file is complete or unchanged.
Result<void> zip_folder(const std::filesystem::path& folder, const std::filesystem::path& zip);

/// Extracts a ZIP file to an existing folder. Fails for a path that leads outside of it.
Result<void> unzip(const std::filesystem::path& zip, const std::filesystem::path& folder);
