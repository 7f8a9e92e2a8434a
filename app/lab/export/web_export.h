#pragma once

#include "lab/export/export_target.h"

struct PortableFiles;

/// Writes a look as a web page that draws it with WebGL 2, see docs/export.md. Media above 10 MB
/// are in a folder next to it. Fails if GLSL ES 3.00 or WebGL 2 lack something that the look needs.
Result<ExportedLook> export_web(const ExportRequest& request);

/// The page of a look that has already been described.
Result<ExportedLook> write_page(const Look& look, const PortableFiles& described,
                                const std::filesystem::path& path);

/// What the page can't do, a sentence per item.
Result<std::vector<std::string>> web_losses(const PreparedLook& prepared);

/// Reads the page again: its shaders compile, and its passes, values and content are those of the
/// look.
Result<void> check_web(const ExportRequest& request);

/// The page itself.
Result<std::filesystem::path> page_of_web(const ExportRequest& request,
                                          const std::filesystem::path& folder);
