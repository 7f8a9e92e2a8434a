#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

/// The graph of passes: a line from each writer to its reader, dashed from earlier frames. Lines of
/// the pass under the pointer, or of the inspected one, are highlighted. Click a pass to inspect
/// it.
void draw_pass_graph(const Scene& scene, Edits& edits);
