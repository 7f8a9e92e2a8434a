#pragma once

#include "graph/executor/frame_graph.h"
#include "graph/targets/target_set.h"

#include <cstdint>
#include <vector>

/// A frame while it is drawn.
struct FrameInProgress {
    const FrameGraph& graph;
    const TargetSet& targets;
    const std::vector<bool>& passes;  // that are drawn in it
    bool is_whole;                    // all passes
    std::int64_t number;
};

/// Reads the targets of an executor while it draws. Called in its context and in a DrawScope.
class FrameObserver {
public:
    virtual ~FrameObserver() = default;
    /// Directly after a pass was drawn: before later passes read its target, and before its mip
    /// levels are generated.
    virtual void pass_drawn(const FrameInProgress& frame, std::size_t pass) = 0;
    /// After the last pass.
    virtual void frame_drawn(const FrameInProgress& frame) = 0;
    /// The look was replaced with an edited one.
    virtual void look_replaced() = 0;
};
