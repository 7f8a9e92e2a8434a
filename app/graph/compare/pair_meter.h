#pragma once

#include "gpu/objects/download.h"
#include "gpu/objects/vertex_array.h"
#include "graph/compare/pair.h"
#include "model/picture/difference.h"
#include "model/plan/step_effect.h"

#include <optional>

/// The mean luminance (ITU-R BT.709, linear light) of what a display shows of two pictures, over
/// the pixels that are finite in both.
struct Luminances {
    double ours = 0.0;
    double other = 0.0;

    bool operator==(const Luminances&) const = default;
};

/// What is known of two pictures together. None where it was not asked for.
struct PairMeasured {
    std::optional<Distances> distances = {};  // as `afterglow compare` counts them
    std::optional<Luminances> luminances = {};
    std::optional<PassChange> change = {};
};

/// Measures two pictures without waiting, as Meter does one: every texel is reduced to sums of
/// blocks, which come back in a later frame.
class PairMeter {
public:
    static Result<PairMeter> make();

    bool is_busy() const { return m_sums_to_come || m_light_to_come || m_change_to_come; }
    /// Asks how far the two are apart, pixels counting as apart beyond `tolerance`; what was under
    /// way is dropped.
    void start_distances(const Pair& pair, double tolerance);
    /// Asks for their light, likewise.
    void start_luminances(const Pair& pair);
    /// Asks what a pass is changed by, likewise; `as_shown`: as far as a display shows it, 0..1.
    void start_change(const Pair& pair, bool as_shown);
    /// The answer, once, when it has come.
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
