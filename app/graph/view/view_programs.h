#pragma once

#include "graph/inspect/meter.h"
#include "graph/inspect/viewer.h"
#include "graph/targets/pass_through.h"

#include <memory>

/// What the pictures of a look's passes are looked at with, by all who do so in one context: for
/// the screen, for their numbers, for their flashes, and turned over where their top row comes
/// first.
struct ViewPrograms {
    static Result<ViewPrograms> make();

    ViewerPrograms viewer;
    MeterPrograms meter;
    gpu::Program cells;
    PassThroughPrograms pass_through;
};

/// One part of them, which keeps them all.
template <class Part>
std::shared_ptr<const Part> part_of(const std::shared_ptr<const ViewPrograms>& programs,
                                    Part ViewPrograms::*part) {
    return {programs, &((*programs).*part)};
}
