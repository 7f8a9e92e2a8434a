#pragma once

#include "lab/export/export_target.h"

/// Writes a look as a web page that draws it with WebGL 2, see docs/web.md. Media above 10 MB are
/// in a folder next to it. Fails if GLSL ES 3.00 or WebGL 2 lack something that the look needs.
Result<ExportedLook> export_web(const ExportRequest& request);

/// What the page can't do, a sentence per item.
std::vector<std::string> web_losses(const PreparedLook& prepared);
