#pragma once

#include "gpu/objects/canvas.h"
#include "gpu/objects/pixel_query.h"
#include "gpu/objects/samplers.h"
#include "gpu/objects/vertex_array.h"
#include "gpu/program.h"

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
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
/// their place before anybody reads them. One draw a target, the targets of a frame together into
/// one picture, and nobody waits for the GPU: what was found is known some frames later.
class Tripwire {
public:
    /// How numbers are put right: each texel where it is, or by way of a second picture, which
    /// every driver can.
    enum class Mending { in_place, there_and_back };
    static Mending best_mending();

    explicit Tripwire(std::shared_ptr<const TripwirePrograms> programs,
                      Mending mending = best_mending())
        : m_programs(std::move(programs)), m_mending(mending) {}

    /// What a pass has drawn.
    struct Drawn {
        std::size_t pass = 0;
        const gpu::Canvas* target = nullptr;
    };
    /// To be called within a DrawScope, while the targets hold what is to be looked at. Frames
    /// count up.
    void look_at(std::span<const Drawn> all, std::int64_t frame);
    /// Right after the pass: what is no number becomes 0, and an infinity the format's largest
    /// number.
    void look_and_mend(const Drawn& drawn, std::int64_t frame);
    /// Looks only if the last look_and_mend() at `cause` found something: the GPU sees to it.
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
    /// The latest looks, whose answers may be under way.
    struct Looks {
        std::array<Look, 4> looks = {};
        std::size_t latest = 0;

        Look& open_next();
    };
    /// What is known of passes, a number a block of texels: see the shader. Each pass has a
    /// rectangle of one, side by side on shelves.
    struct Sheet {
        gpu::Canvas blocks;
        int x = 0;  // where the next one has room
        int y = 0;
        int shelf_height = 0;

        bool find_room(Extent part, int& left, int& bottom);
    };
    struct Watch {
        Extent target;  // px
        std::size_t sheet = 0;
        int x = 0;  // of its rectangle
        int y = 0;
        Looks looks = {};
    };
    void begin(std::int64_t frame);
    void draw_found(const Watch& watch, const gpu::Texture& target, std::int64_t frame);
    Watch* watch_for(std::size_t pass, const gpu::Texture& target);
    bool place(Watch& watch);
    void draw_mended(const gpu::Canvas& target);
    void draw_mender(const gpu::Canvas& from, const gpu::Canvas& to);
    const gpu::Canvas* spare_for(const gpu::Texture& target);
    bool take_answers(bool waits);
    std::optional<Trip> first_in(std::size_t pass, const Watch& watch, const Picture& sheet) const;

    std::shared_ptr<const TripwirePrograms> m_programs;
    Mending m_mending;
    std::vector<gpu::Canvas> m_spares;  // one of each size and format
    gpu::VertexArray m_vertices;
    gpu::Samplers m_samplers;
    std::map<std::size_t, Watch> m_watches;
    std::vector<Sheet> m_sheets;
    Looks m_gathered;                           // at several passes at once
    std::optional<std::int64_t> m_first_frame;  // that the blocks count from
    std::optional<Trip> m_found;                // before they began to count anew
};
