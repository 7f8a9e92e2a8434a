#pragma once

#include "base/pass_progress.h"
#include "gpu/objects/canvas.h"
#include "gpu/objects/vertex_array.h"
#include "graph/warm_up/first_draws.h"

/// Makes programs ready on a helper thread whose context shares with the drawing one.
///
/// A context of Mesa's keeps what it drew with last. If the drawing context deletes that program,
/// it is freed here when the next one is drawn with, and this takes from the drawing context, at
/// its next flush, the stages that it has bound; what it then draws with the same program ends in
/// the driver (seen with 22.3). So here the first and the last draws are with programs of our own.
class WarmUp {
public:
    /// On the helper thread, in whose context it also ends.
    static Result<WarmUp> make();

    /// All first draws, unless they are cancelled.
    void draw(const FirstDrawsOf& of, PassProgress& progress) const;

private:
    WarmUp(PassProgram first, PassProgram last, gpu::Canvas canvas);
    void draw_with(const PassProgram& program) const;

    PassProgram m_first;  // two, or a flush between could take the stages of the only one
    PassProgram m_last;
    gpu::Canvas m_canvas;
    gpu::VertexArray m_vertices;
};
