#pragma once

#include "base/diagnostic.h"
#include "base/pass_progress.h"
#include "gpu/context.h"
#include "gpu/program.h"
#include "model/look/look.h"

#include <memory>
#include <vector>

class FirstViews;
struct TripwirePrograms;
struct ViewPrograms;

/// What a pass compiles to, and from what.
struct PassProgram {
    SharedText vertex;
    SharedText fragment;
    Draw draw = Draw::fullscreen;
    Values set;
    // Shared: the look on the screen and the one being made from it keep what both have.
    std::shared_ptr<const gpu::Program> program;
};

/// One linked program a pass, in the look's order.
struct Programs {
    std::vector<PassProgram> passes;
    // Where executors draw with them; null: in whichever context they are made in.
    std::shared_ptr<gpu::Context> home = {};
    // Of the executors' guard; null: each makes its own.
    std::shared_ptr<const TripwirePrograms> tripwire = {};
    // What the passes are looked at with, at home; null: nobody does.
    std::shared_ptr<const ViewPrograms> views = {};
    // What has been met with them; null: there is no home.
    std::shared_ptr<FirstViews> first_views = {};
};

/// The passes of both, each program once.
Programs joined(Programs first, const Programs& second);

/// Whether build_programs() would take all of `look` from `programs`.
bool serves(const Programs& programs, const Look& look);

/// Compiles and links; may run on a helper thread whose context shares with the drawing one. Passes
/// whose stages, draw mode and fixed uniforms equal those of one in `reuse` take its program. Fails
/// with what the driver refuses, of all passes at once, at the author's files and lines. `kept` as
/// in gpu::Program::build. `progress` may be null; cancelled there, it fails. What is new ends in
/// `home`.
Result<Programs> build_programs(const Look& look, const Programs* reuse = nullptr,
                                ByteStore* kept = nullptr, PassProgress* progress = nullptr,
                                const std::shared_ptr<gpu::Context>& home = nullptr);
