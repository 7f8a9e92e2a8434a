#include "lab/frame/wanted_subframes.h"

#include "lab/frame/workspace.h"
#include "model/look/subframe.h"

#include <algorithm>

int wanted_subframes(const Workspace& work) {
    const FrameGraph& graph = work.renderer->executor().graph();
    const bool draws = work.player.transport().is_playing() && work.draws_subframes;
    return draws
               ? std::min(subframes_of(graph.look(), graph.values()), work.display.most_subframes())
               : 1;
}
