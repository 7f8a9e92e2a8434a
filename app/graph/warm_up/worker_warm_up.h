#pragma once

#include "base/pass_progress.h"
#include "gpu/objects/canvas.h"
#include "gpu/objects/vertex_array.h"
#include "graph/warm_up/first_draws.h"

/// Warms up programs on a worker thread whose context shares with the drawing context.
///
/// A Mesa context (22.3) keeps the program that it drew with last. If the drawing context deletes
/// that program, the worker's next draw frees it. At its next flush, the drawing context then loses
/// its bound stages. Its next draw with the same program crashes in the driver. Therefore the first
/// and last draws here use two programs of our own.
class WorkerWarmUp {
public:
    /// On the worker thread, whose context must be current when it is destroyed.
    static Result<WorkerWarmUp> make();

    /// Draws all first draws unless cancelled.
    void draw(const FirstDrawsInput& of, PassProgress& progress) const;

private:
    WorkerWarmUp(PassProgram first, PassProgram last, gpu::Canvas canvas);
    void draw_with(const PassProgram& program) const;

    PassProgram m_first;  // two: a flush in between could drop the stages of a single one
    PassProgram m_last;
    gpu::Canvas m_canvas;
    gpu::VertexArray m_vertices;
};
