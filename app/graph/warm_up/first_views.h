#pragma once

#include "graph/inspect/light_cells.h"
#include "graph/inspect/meter.h"
#include "graph/inspect/viewer.h"
#include "graph/view/view_programs.h"
#include "model/plan/plan.h"

#include <array>
#include <cstddef>
#include <deque>
#include <memory>
#include <optional>
#include <set>
#include <tuple>

/// Warms up the programs that display passes in one context. Each kind of picture is drawn once
/// from a small texture in all ways that the window uses: minified, magnified, statistics, flashes.
/// A driver compiles for a kind of picture at its first draw in a context. Belongs to the context
/// that it is created in.
class FirstViews {
public:
    /// `programs` may come from another context that shares with the current one.
    explicit FirstViews(std::shared_ptr<const ViewPrograms> programs);

    const std::shared_ptr<const ViewPrograms>& programs() const { return m_programs; }
    /// Schedules the kinds of pictures that these passes draw and that were not scheduled before.
    void expect(const Look& look, const Plan& plan);
    std::size_t pending() const { return m_pending.size(); }
    /// Draws one scheduled kind in one way and waits for it.
    void draw_next();

private:
    /// The properties for which drivers compile separately.
    struct Kind {
        Format format;
        Encoding encoding;
        bool is_mipmapped;
        std::array<bool, 2> has_power_of_two;  // width, height
        bool has_alpha;

        auto tie() const {
            return std::tie(format, encoding, is_mipmapped, has_power_of_two, has_alpha);
        }
        bool operator<(const Kind& other) const { return tie() < other.tie(); }
        bool operator==(const Kind& other) const { return tie() == other.tie(); }
    };
    enum class Way {
        minified,
        magnified,
        minified_over_checker,
        magnified_over_checker,
        numbers,
        flashes
    };
    struct PendingDraw {
        Kind kind;
        Way way;
    };
    struct Seen {
        Kind kind;
        gpu::Canvas canvas;
    };
    void expect(const Kind& kind);
    const gpu::Texture* picture_of(const Kind& kind);
    void draw_views_of(const gpu::Texture& texture, const PendingDraw& pending);
    void view(const gpu::Texture& texture, const PendingDraw& pending);

    std::shared_ptr<const ViewPrograms> m_programs;
    Viewer m_viewer;
    Meter m_meter;
    LightCells m_cells;
    std::set<Kind> m_scheduled;
    std::deque<PendingDraw> m_pending;
    std::optional<Seen> m_displayed;
};
