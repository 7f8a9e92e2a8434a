#pragma once

#include "parity/plain_chain.h"

#include <memory>
#include <vector>

namespace bench {

/// A Gaussian tap by tap, across and then down, as a plain GL program draws it.
class PlainBlur {
public:
    /// `taps`: an odd number, a texel apart; their weights add up to 1. `sigma` in texels.
    static Result<PlainBlur> make(Extent extent, int taps, double sigma);

    void draw() const;
    /// What is blurred: a single lit texel in the middle.
    Picture lit() const { return read(m_lit); }
    Picture blurred() const { return read(*m_down); }

private:
    explicit PlainBlur(Extent extent);
    static Picture read(const plain::Surface& surface);

    plain::Surface m_lit;
    std::unique_ptr<plain::Surface> m_across;
    std::unique_ptr<plain::Surface> m_down;
    std::vector<gpu::Program> m_programs;
    gpu::Name<plain::delete_vertex_array_name> m_vertices;
    gpu::Name<plain::delete_sampler_name> m_sampler;
};

}  // namespace bench
