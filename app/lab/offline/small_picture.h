#pragma once

#include "gpu/objects/canvas.h"
#include "graph/executor/executor.h"
#include "graph/inspect/viewer.h"

/// A display-encoded copy of the last pass, at most `height` lines high. Fails without memory.
Result<gpu::Canvas> small_picture(Viewer& viewer, const Executor& executor, int height);

/// The render size for small pictures: at most 270 lines. Reducing from this size keeps patterns
/// measured in pixels (masks, scanlines) close to the original.
Extent size_for_small_picture(Extent picture);
