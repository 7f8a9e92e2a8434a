#pragma once

#include "gpu/canvas.h"
#include "gpu/pixel_query.h"
#include "gpu/program.h"
#include "gpu/samplers.h"
#include "gpu/vertex_array.h"

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

/// Where a number that is not finite was drawn first.
struct Trip {
    std::size_t pass = 0;
    int x = 0;  // px from the left and from the top
    int y = 0;
    std::int64_t frame = 0;

    bool operator==(const Trip&) const = default;
};

/// What a Tripwire draws with.
struct TripwirePrograms {
    std::shared_ptr<const gpu::Program> finder;
    std::shared_ptr<const gpu::Program> mender;
};

/// They end in `home`.
Result<std::shared_ptr<const TripwirePrograms>> build_tripwire(
    const std::shared_ptr<gpu::Context>& home = nullptr);

/// Looks at what passes have drawn for numbers that are not finite, and may put finite ones in
/// their place before anybody reads them. One draw a target, and nobody waits for the GPU: what was
/// found is known some frames later.
class Tripwire {
public:
    /// How numbers are put right: each texel where it is, or by way of a second picture, which
    /// every driver can.
    enum class Mending { in_place, there_and_back };
    static Mending best_mending();

    explicit Tripwire(std::shared_ptr<const TripwirePrograms> programs,
                      Mending mending = best_mending())
        : m_programs(std::move(programs)), m_mending(mending) {}

    /// To be called within a DrawScope, right after the pass. Frames count up. With `clamps` what
    /// is no number becomes 0, and an infinity the format's largest number.
    void look_at(std::size_t pass, const gpu::Canvas& target, std::int64_t frame, bool clamps);
    /// As look_at() without clamping, but only if the last look at `cause` found something: the GPU
    /// sees to it.
    void look_behind(std::size_t cause, std::size_t pass, const gpu::Canvas& target,
                     std::int64_t frame);
    /// Puts finite numbers in the place of others, without looking where.
    void mend(const gpu::Canvas& target);

    /// The first that was found since last asked: of the earliest frame, in its first pass. With
    /// `waits` also what the GPU is still at.
    std::optional<Trip> take(bool waits = false);
    /// Whether the GPU is still at something that was looked at.
    bool is_waiting() const;
    /// Forgets what was found.
    void clear();

private:
    struct Look {
        gpu::PixelQuery query;
        bool is_open = false;
    };
    /// What is known of a pass: a number a block of texels, see the shader.
    struct Watch {
        gpu::Canvas blocks;
        Extent target;  // px
        std::array<Look, 4> looks = {};
        std::size_t latest = 0;
    };
    void begin(std::int64_t frame);
    void draw_found(const Watch& watch, const gpu::Texture& target, std::int64_t frame);
    Watch* watch_for(std::size_t pass, const gpu::Texture& target);
    void draw_mended(const gpu::Canvas& target);
    void draw_mender(const gpu::Canvas& from, const gpu::Canvas& to);
    const gpu::Canvas* spare_for(const gpu::Texture& target);
    std::optional<Trip> first_in(std::size_t pass, const Watch& watch) const;

    std::shared_ptr<const TripwirePrograms> m_programs;
    Mending m_mending;
    std::vector<gpu::Canvas> m_spares;  // one of each size and format
    gpu::VertexArray m_vertices;
    gpu::Samplers m_samplers;
    std::map<std::size_t, Watch> m_watches;
    std::optional<std::int64_t> m_first_frame;  // that the blocks count from
    std::optional<Trip> m_found;                // before they began to count anew
};
