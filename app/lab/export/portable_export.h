#pragma once

#include "lab/export/export_target.h"

/// Writes a look as a folder that other programs can draw, see docs/portable.md. An earlier export
/// of the same path is replaced. Fails if another file or folder is there.
Result<ExportedLook> export_portable(const ExportRequest& request);
