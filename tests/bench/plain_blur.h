#pragma once

#include "parity/plain_chain.h"

#include <memory>
#include <vector>

namespace bench {

/// A separable Gaussian blur in plain GL, tap by tap, horizontal then vertical.
class PlainBlur {
public:
    /// `taps`: an odd number, one texel apart; their weights sum to 1. `sigma` in texels.
    static Result<PlainBlur> make(Extent extent, int taps, double sigma);

    void draw() const;
    /// The input: a single lit texel in the middle.
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
