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

/// The first NaN or infinity that was drawn.
struct NonFinitePixel {
    std::size_t pass = 0;
    int x = 0;  // px from the left and the top
    int y = 0;
    std::int64_t frame = 0;

    bool operator==(const NonFinitePixel&) const = default;
};

/// The programs of a NanDetector.
struct NanDetectorPrograms {
    std::shared_ptr<const gpu::Program> finder;
    std::shared_ptr<const gpu::Program> sanitizer;
};

/// The programs are destroyed in `context`.
Result<std::shared_ptr<const NanDetectorPrograms>> build_nan_detector(
    const std::shared_ptr<gpu::Context>& context = nullptr);

/// Detects NaN and infinity in the outputs of passes, and can replace them with finite numbers
/// before they are read. Each target takes one draw, and all targets of a frame share one picture.
/// Nothing waits for the GPU: results are available some frames later.
class NanDetector {
public:
    /// How numbers are replaced: each texel in place, or through a second picture, which all
    /// drivers support.
    enum class SanitizeMethod { in_place, ping_pong };
    static SanitizeMethod best_method();

    explicit NanDetector(std::shared_ptr<const NanDetectorPrograms> programs,
                         SanitizeMethod method = best_method())
        : m_programs(std::move(programs)), m_method(method) {}

    /// The output of a pass.
    struct Drawn {
        std::size_t pass = 0;
        const gpu::Canvas* target = nullptr;
    };
    /// Checks targets. Call in a DrawScope while the targets hold the contents to check. Frame
    /// numbers must increase.
    void check(std::span<const Drawn> all, std::int64_t frame);
    /// Call directly after the pass. If the check finds something, NaN becomes 0 and infinities
    /// become the largest number of the format.
    void check_and_sanitize(const Drawn& drawn, std::int64_t frame);
    /// Checks only if the last check_and_sanitize() of `cause` found something. The GPU decides
    /// this.
    void check_cause(std::size_t cause, std::size_t pass, const gpu::Canvas& target,
                     std::int64_t frame);
    /// Replaces such numbers without a check.
    void sanitize(const gpu::Canvas& target);

    /// The first finding since the last call: of the earliest frame, in its first pass. With
    /// `waits` it waits for pending checks.
    std::optional<NonFinitePixel> take(bool waits = false);
    /// Whether checks are pending on the GPU.
    bool is_waiting() const;
    /// Discards the findings.
    void clear();

private:
    struct PendingQuery {
        gpu::PixelQuery query;
        bool is_open = false;
    };
    /// The latest checks, whose results may be pending.
    struct QueryRing {
        std::array<PendingQuery, 4> queries = {};
        std::size_t latest = 0;

        PendingQuery& open_next();
    };
    /// Findings of passes, one number per block of texels: see the shader. Each pass has a
    /// rectangle. Rectangles are packed next to each other on shelves.
    struct Sheet {
        gpu::Canvas blocks;
        int x = 0;  // position of the next rectangle
        int y = 0;
        int shelf_height = 0;

        bool find_room(Extent part, int& left, int& bottom);
    };
    struct Watch {
        Extent target;  // px
        std::size_t sheet = 0;
        int x = 0;  // of its rectangle
        int y = 0;
        QueryRing queries = {};
    };
    void begin(std::int64_t frame);
    void draw_found(const Watch& watch, const gpu::Texture& target, std::int64_t frame);
    Watch* watch_for(std::size_t pass, const gpu::Texture& target);
    bool allocate(Watch& watch);
    void draw_sanitized(const gpu::Canvas& target);
    void draw_sanitizer(const gpu::Canvas& from, const gpu::Canvas& to);
    const gpu::Canvas* spare_for(const gpu::Texture& target);
    bool take_answers(bool waits);
    std::optional<NonFinitePixel> first_in(std::size_t pass, const Watch& watch,
                                           const Picture& sheet) const;

    std::shared_ptr<const NanDetectorPrograms> m_programs;
    SanitizeMethod m_method;
    std::vector<gpu::Canvas> m_spares;  // one of each size and format
    gpu::VertexArray m_vertices;
    gpu::Samplers m_samplers;
    std::map<std::size_t, Watch> m_watches;
    std::vector<Sheet> m_sheets;
    QueryRing m_gathered;                       // checks of several passes at once
    std::optional<std::int64_t> m_first_frame;  // first frame of the codes
    std::optional<NonFinitePixel> m_found;      // from before the codes restarted
};
