#pragma once

#include "gpu/objects/download.h"
#include "gpu/objects/samplers.h"
#include "gpu/objects/vertex_array.h"
#include "graph/inspect/viewer.h"
#include "graph/programs/sample_programs.h"
#include "model/picture/statistics.h"

#include <optional>

/// The measurements of a target.
struct Measured {
    Statistics statistics;    // of all texels
    Picture samples;          // at most 256 x 256 evenly spread texels; grey for one channel
    std::size_t clipped = 0;  // texels with a finite number at the ceiling or above
};

/// The programs of a Meter.
struct MeterPrograms {
    static Result<MeterPrograms> make();

    SamplePrograms all;
};

/// Measures targets without waiting for the GPU. One draw reduces all texels to sums of blocks, and
/// one takes samples. Both are read back in a later frame.
class Meter {
public:
    explicit Meter(std::shared_ptr<const MeterPrograms> programs)
        : m_programs(std::move(programs)) {}

    /// Whether a request is pending.
    bool is_busy() const { return m_blocks_to_come.has_value(); }
    /// Starts a request and drops a pending one. With a ceiling, texels that reach it are counted.
    void start(const gpu::Texture& from, Channels channels,
               std::optional<double> ceiling = std::nullopt);
    /// The result, once, when it is available.
    std::optional<Measured> take();
    /// Drops a pending request.
    void stop();

private:
    void draw(const gpu::Texture& from, const gpu::Program& program, Channels channels,
              std::optional<double> ceiling);

    std::shared_ptr<const MeterPrograms> m_programs;  // shared within a context
    gpu::VertexArray m_vertices;
    gpu::Samplers m_samplers;
    std::optional<gpu::Canvas> m_blocks;
    std::optional<gpu::Canvas> m_samples;
    std::optional<gpu::Download> m_blocks_to_come;
    std::optional<gpu::Download> m_samples_to_come;
    Extent m_measured;  // size of the target
    bool m_is_color = true;
};
