#pragma once

#include "gpu/objects/canvas.h"
#include "graph/executor/executor.h"
#include "graph/inspect/viewer.h"
#include "lab/rendering/renderer.h"
#include "model/look/picture.h"

#include <optional>

/// A display-encoded copy of the last pass, at most `height` lines high. Fails without memory.
Result<gpu::Canvas> thumbnail(Viewer& viewer, const Executor& executor, int height);

/// A small copy of the picture that the window shows, 135 lines; nullopt: nothing is drawn yet.
std::optional<Picture> small_copy(const Renderer* renderer);

/// The render size for small pictures: at most 270 lines. Reducing from this size keeps patterns
/// measured in pixels (masks, scanlines) close to the original.
Extent size_for_small_picture(Extent picture);
