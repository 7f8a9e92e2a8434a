#pragma once

#include "gpu/objects/download.h"
#include "gpu/objects/vertex_array.h"
#include "graph/compare/pair.h"
#include "model/picture/difference.h"
#include "model/plan/step_effect.h"

#include <optional>

/// The mean luminance (ITU-R BT.709, linear light) of two pictures as displayed, over the pixels
/// that are finite in both.
struct Luminances {
    double ours = 0.0;
    double other = 0.0;

    bool operator==(const Luminances&) const = default;
};

/// The measurements of two pictures; nullopt: not requested.
struct PairMeasured {
    std::optional<Distances> distances = {};  // as in `afterglow compare`
    std::optional<Luminances> luminances = {};
    std::optional<PassChange> change = {};
};

/// Measures two pictures without waiting for the GPU, as Meter measures one. Texels are reduced to
/// sums of blocks, which are read back in a later frame.
class PairMeter {
public:
    static Result<PairMeter> make();

    bool is_busy() const { return m_sums_to_come || m_light_to_come || m_change_to_come; }
    /// Requests the differences. Pixels beyond `tolerance` count as different. Drops a pending
    /// request.
    void start_distances(const Pair& pair, double tolerance);
    /// Requests the luminances. Drops a pending request.
    void start_luminances(const Pair& pair);
    /// Requests the change of a pass; `as_shown`: clamped to the displayed range, 0..1. Drops a
    /// pending request.
    void start_change(const Pair& pair, bool as_shown);
    /// The result, once, when it is available.
    std::optional<PairMeasured> take();
    void stop();

private:
    PairMeter(gpu::Program distances, gpu::Program light, gpu::Program change);
    bool draw(const Pair& pair, const gpu::Program& program);

    gpu::Program m_distances;
    gpu::Program m_light;
    gpu::Program m_change;
    gpu::VertexArray m_vertices;
    gpu::Samplers m_samplers;
    std::optional<gpu::Canvas> m_blocks;
    std::optional<gpu::Download> m_sums_to_come;
    std::optional<gpu::Download> m_light_to_come;
    std::optional<gpu::Download> m_change_to_come;
    Extent m_measured;
};
