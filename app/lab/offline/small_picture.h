#pragma once

#include "gpu/objects/canvas.h"
#include "graph/executor/executor.h"
#include "graph/inspect/viewer.h"

/// A copy of what the last pass holds, as a display shows it and at most `height` lines high. Fails
/// where there is no memory.
Result<gpu::Canvas> small_picture(Viewer& viewer, const Executor& executor, int height);

/// The size at which a look is drawn for small pictures of it: at most 270 lines, so that what is
/// measured in pixels (masks, scanlines) stays near what it is.
Extent size_for_small_picture(Extent picture);
