#pragma once

#include "lab/export/export_target.h"

/// Writes a look as a folder that other programs can draw, see docs/portable.md. An earlier export
/// of the same path is replaced. Fails if another file or folder is there.
Result<ExportedLook> export_portable(const ExportRequest& request);

/// Nothing but the movement of a test picture.
Result<std::vector<std::string>> portable_losses(const PreparedLook& prepared);

/// Reads the folder again: all files are there, the shaders compile, and the description is that of
/// the look.
Result<void> check_portable(const ExportRequest& request);

/// Makes a web page from the files of the folder.
Result<std::filesystem::path> page_of_portable(const ExportRequest& request,
                                               const std::filesystem::path& folder);
