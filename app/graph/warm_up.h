#pragma once

#include "gpu/canvas.h"
#include "gpu/vertex_array.h"
#include "graph/programs.h"
#include "model/extent.h"

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

    /// Draws once with each program of `programs` that `known` lacks, into targets of the look's
    /// formats but a few pixels large. A driver makes a program's code when it is first drawn with,
    /// for the states that it meets there; done here, the picture does not wait for it. `viewport`
    /// is the size that the picture will have. Programs in `known` may be in use and are not
    /// touched.
    void draw(const Look& look, const Programs& programs, const Programs* known,
              Extent viewport) const;

private:
    WarmUp(PassProgram first, PassProgram last, gpu::Canvas canvas);
    void draw_with(const PassProgram& program) const;

    PassProgram m_first;  // two, or a flush between could take the stages of the only one
    PassProgram m_last;
    gpu::Canvas m_canvas;
    gpu::VertexArray m_vertices;
};
