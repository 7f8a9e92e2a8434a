#pragma once

#include "gpu/objects/canvas.h"
#include "graph/inspect/viewer.h"
#include "graph/programs/programs.h"
#include "lab/inspect/flash_meter.h"
#include "lab/inspect/gain_meters.h"
#include "lab/inspect/inspection.h"

#include <memory>
#include <optional>

/// The view programs and meters for the passes of a look, in the context that draws it. There the
/// driver has already compiled their shaders. In other contexts, call them within a
/// gpu::ContextScope of `context`.
struct ContextViews {
    explicit ContextViews(const Programs& programs);
    ~ContextViews() { scope = std::make_unique<gpu::ContextScope>(context.get()); }
    ContextViews(const ContextViews&) = delete;
    ContextViews& operator=(const ContextViews&) = delete;

    /// Whether they belong to the context and view programs of `other`.
    bool serve(const Programs& other) const {
        return programs == other.views && context == other.context;
    }

    std::shared_ptr<const ViewPrograms> programs;
    std::shared_ptr<gpu::Context> context;
    std::unique_ptr<gpu::ContextScope> scope;  // only to construct and destroy the members below
    Viewer viewer;
    Inspection inspection;
    LevelMeters gains;
    FlashMeter flash_meter;
    std::optional<gpu::Canvas> picture;
    std::optional<gpu::Canvas> reference;
    std::optional<gpu::Canvas> output;
    std::optional<gpu::Canvas> inspected;
};
