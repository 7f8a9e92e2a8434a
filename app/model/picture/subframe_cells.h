#pragma once

#include "model/look/subframe.h"
#include "model/picture/flash.h"

#include <optional>
#include <span>
#include <vector>

/// Combines the cells of sub-frames: the eye sees the mean of a source frame, if source frames
/// follow at 50 Hz or more.
class SubframeCells {
public:
    /// The mean cells of a source frame, with its last sub-frame. nullopt: it is not complete, or
    /// sub-frames are missing.
    std::optional<std::vector<Light>> add(const Subframe& subframe, std::span<const Light> cells);

private:
    std::vector<Light> m_sum;
    Subframe m_next;  // that fits to the sum
};
