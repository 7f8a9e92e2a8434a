#pragma once

#include "base/diagnostic.h"
#include "base/pass_progress.h"
#include "gpu/context.h"
#include "gpu/program.h"
#include "model/look/look.h"

#include <memory>
#include <vector>

class FirstViews;
struct NanDetectorPrograms;
struct ViewPrograms;

/// The linked program of a pass and what it was built from.
struct PassProgram {
    SharedText vertex;
    SharedText fragment;
    Draw draw = Draw::fullscreen;
    Values set;
    // Shared by the displayed look and the look that is being built from it.
    std::shared_ptr<const gpu::Program> program;
};

/// One linked program per pass, in the order of the look.
struct Programs {
    std::vector<PassProgram> passes;
    // The context that executors draw in; null: the one that is current when they are created.
    std::shared_ptr<gpu::Context> context = {};
    // Programs of the NaN detector; null: each executor builds its own.
    std::shared_ptr<const NanDetectorPrograms> nan_detector = {};
    // The programs that display passes in `context`; null: passes are not displayed.
    std::shared_ptr<const ViewPrograms> views = {};
    // The warm-up of `views`; null without `context`.
    std::shared_ptr<FirstViews> first_views = {};
};

/// The passes of both, each program once.
Programs joined(Programs first, const Programs& second);

/// Whether build_programs() would reuse programs of `programs` for all passes of `look`.
bool serves(const Programs& programs, const Look& look);

/// Compiles and links. May run on a worker thread whose context shares with the drawing context. A
/// pass reuses a program of `reuse` with equal stages, draw mode and fixed uniforms. Fails with the
/// driver's errors of all passes, at the author's files and lines. `store` is as in
/// gpu::Program::build. `progress` may be null; if cancelled there, it fails. New programs are
/// destroyed in `context`.
Result<Programs> build_programs(const Look& look, const Programs* reuse = nullptr,
                                ByteStore* store = nullptr, PassProgress* progress = nullptr,
                                const std::shared_ptr<gpu::Context>& context = nullptr);
