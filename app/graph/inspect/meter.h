#pragma once

#include "gpu/objects/download.h"
#include "gpu/objects/samplers.h"
#include "gpu/objects/vertex_array.h"
#include "graph/inspect/viewer.h"
#include "graph/programs/sample_programs.h"
#include "model/picture/statistics.h"

#include <optional>

/// What is known of the numbers in a target.
struct Measured {
    Statistics statistics;    // of every texel
    Picture samples;          // at most 256 x 256 texels spread evenly; of lone channels grey
    std::size_t clipped = 0;  // texels with a finite number at the ceiling or above
};

/// What meters draw with.
struct MeterPrograms {
    static Result<MeterPrograms> make();

    SamplePrograms all;
};

/// Measures targets without waiting: one draw reduces every texel to sums of blocks, one takes
/// samples, and both come back in a later frame.
class Meter {
public:
    explicit Meter(std::shared_ptr<const MeterPrograms> programs)
        : m_programs(std::move(programs)) {}

    /// Whether an answer is under way.
    bool is_busy() const { return m_blocks_to_come.has_value(); }
    /// Asks; what was under way is dropped. Texels at a ceiling are counted where one is given.
    void start(const gpu::Texture& from, ChannelChoice channels,
               std::optional<double> ceiling = std::nullopt);
    /// The answer, once, when it has come.
    std::optional<Measured> take();
    /// Lets go of what was under way.
    void stop();

private:
    void draw(const gpu::Texture& from, const gpu::Program& program, ChannelChoice channels,
              std::optional<double> ceiling);

    std::shared_ptr<const MeterPrograms> m_programs;  // of who looks in the same context
    gpu::VertexArray m_vertices;
    gpu::Samplers m_samplers;
    std::optional<gpu::Canvas> m_blocks;
    std::optional<gpu::Canvas> m_samples;
    std::optional<gpu::Download> m_blocks_to_come;
    std::optional<gpu::Download> m_samples_to_come;
    Extent m_measured;  // size of the target
    bool m_is_color = true;
};
