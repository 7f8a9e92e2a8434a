#pragma once

#include "gpu/objects/download.h"
#include "gpu/objects/samplers.h"
#include "gpu/objects/vertex_array.h"
#include "graph/programs/sample_programs.h"

#include <array>
#include <optional>
#include <vector>

/// A texel of a target, `y` down from the top.
struct TexelPosition {
    const gpu::Texture& target;
    int x = 0;
    int y = 0;
};

/// Reads the stored numbers of a few texels of any targets without waiting for the GPU. They are
/// available in a later frame.
class PointReader {
public:
    static Result<PointReader> make();

    /// Whether a request is pending.
    bool is_busy() const { return m_to_come.has_value(); }
    /// Starts a request and drops a pending one.
    void start(const std::vector<TexelPosition>& positions);
    /// RGBA of each texel, once, when available. Channels that a format lacks are 0, alpha 1.
    std::optional<std::vector<std::array<float, 4>>> take();
    void stop() { m_to_come.reset(); }

private:
    explicit PointReader(SamplePrograms programs) : m_programs(std::move(programs)) {}

    SamplePrograms m_programs;
    gpu::VertexArray m_vertices;
    gpu::Samplers m_samplers;
    std::optional<gpu::Canvas> m_canvas;  // one row
    std::optional<gpu::Download> m_to_come;
};
