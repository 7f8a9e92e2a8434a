#pragma once

#include "gpu/objects/canvas.h"
#include "graph/inspect/viewer.h"
#include "graph/programs/programs.h"
#include "lab/inspect/flash_meter.h"
#include "lab/inspect/gain_meters.h"
#include "lab/inspect/inspection.h"

#include <memory>
#include <optional>

/// Those who look at the passes of a look, in the context that it draws in: there the driver has
/// met what they look at. From elsewhere they are called within a gpu::ContextScope of `home`.
struct HomeViews {
    explicit HomeViews(const Programs& programs);
    ~HomeViews() { scope = std::make_unique<gpu::ContextScope>(home.get()); }
    HomeViews(const HomeViews&) = delete;
    HomeViews& operator=(const HomeViews&) = delete;

    /// Whether they look at passes that are drawn with these.
    bool serve(const Programs& other) const {
        return programs == other.views && home == other.home;
    }

    std::shared_ptr<const ViewPrograms> programs;
    std::shared_ptr<gpu::Context> home;
    std::unique_ptr<gpu::ContextScope> scope;  // around beginning and end of what follows
    Viewer viewer;
    Inspection inspection;
    GainMeters gains;
    FlashMeter flash_meter;
    std::optional<gpu::Canvas> picture;
    std::optional<gpu::Canvas> beside;
    std::optional<gpu::Canvas> output;
    std::optional<gpu::Canvas> inspected;
};
