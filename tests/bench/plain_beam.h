#pragma once

#include "model/look/picture.h"
#include "model/plan/beam.h"
#include "parity/plain_chain.h"

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace bench {

/// A beam in plain GL: a rectangle around each segment, five sigmas wide on each side, with the
/// integral of the spot along the segment. All samples are drawn without merging.
class PlainBeam {
public:
    /// `sigma`: px.
    static Result<PlainBeam> make(Extent extent, double sigma);

    void draw(std::span<const BeamPoint> points);
    /// Light in every channel; top row first.
    Picture picture() const;

private:
    PlainBeam(Extent extent, gpu::Program program);

    std::unique_ptr<plain::Surface> m_target;
    gpu::Program m_program;
    std::vector<gpu::Name<plain::delete_buffer_name>> m_buffer;
    std::vector<gpu::Name<plain::delete_vertex_array_name>> m_vertices;
};

}  // namespace bench
