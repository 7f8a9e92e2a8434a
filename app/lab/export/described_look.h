#pragma once

#include "formats/portable/portable_json.h"
#include "lab/export/export_target.h"

/// The description of a look that all exports are made from. Reads the notices of its source files,
/// and the scene or drawing of its signal.
Result<PortableFiles> described_files(const ExportRequest& request);

/// The comments about author and licence of a look's source files. Errors name the file.
Result<SourceNotices> notices_of(const Look& look);
