#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

/// Which pass reads what: a line from each writer to its reader, dashed from earlier frames. The
/// lines of the pass under the pointer, or of the inspected one, stand out; a click inspects.
void draw_pass_graph(const Scene& scene, Edits& edits);
