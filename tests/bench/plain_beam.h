#pragma once

#include "model/look/picture.h"
#include "model/plan/beam.h"
#include "parity/plain_chain.h"

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace bench {

/// A beam as a plain GL program draws it: a rectangle around the way between any two samples, five
/// sigmas out, with the integral of the spot along it; all samples, as they come.
class PlainBeam {
public:
    /// `sigma`: px.
    static Result<PlainBeam> make(Extent extent, double sigma);

    void draw(std::span<const BeamPoint> points);
    /// Light in every channel; the top row first.
    Picture picture() const;

private:
    PlainBeam(Extent extent, gpu::Program program);

    std::unique_ptr<plain::Surface> m_target;
    gpu::Program m_program;
    std::vector<gpu::Name<plain::delete_buffer_name>> m_buffer;
    std::vector<gpu::Name<plain::delete_vertex_array_name>> m_vertices;
};

}  // namespace bench
