#pragma once

#include "graph/inspect/meter.h"
#include "graph/inspect/viewer.h"
#include "graph/targets/pass_through.h"

#include <memory>

/// The programs for viewing pictures of passes, shared within a context: display, statistics,
/// flashes, and flipping of pictures whose top row comes first.
struct ViewPrograms {
    static Result<ViewPrograms> make();

    ViewerPrograms viewer;
    MeterPrograms meter;
    gpu::Program cells;
    PassThroughPrograms pass_through;
};

/// One part of the programs. It shares ownership of all.
template <class Part>
std::shared_ptr<const Part> part_of(const std::shared_ptr<const ViewPrograms>& programs,
                                    Part ViewPrograms::*part) {
    return {programs, &((*programs).*part)};
}
