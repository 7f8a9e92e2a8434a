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

/// The programs that pictures of passes are looked at with in one context, and what they have been
/// drawn with there: each kind of picture once before somebody waits for it, at a small texture, in
/// the ways that a window looks: large and small, its numbers, its flashes. A driver makes its code
/// for a kind when a context first meets it. Belongs to the context that it is made in.
class FirstViews {
public:
    /// `programs` may come from another context that shares with it.
    explicit FirstViews(std::shared_ptr<const ViewPrograms> programs);

    const std::shared_ptr<const ViewPrograms>& programs() const { return m_programs; }
    /// What these passes draw is to be met, but for what was met before.
    void expect(const Look& look, const Plan& plan);
    std::size_t owed() const { return m_owed.size(); }
    /// Meets one of what is owed, in one way, and waits for it.
    void draw_next();

private:
    /// What drivers tell apart.
    struct Kind {
        Format format;
        Encoding encoding;
        bool is_mipmapped;
        std::array<bool, 2> has_power_of_two;  // across, up
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
    struct Owed {
        Kind kind;
        Way way;
    };
    struct Seen {
        Kind kind;
        gpu::Canvas canvas;
    };
    void expect(const Kind& kind);
    const gpu::Texture* picture_of(const Kind& kind);
    void look_at(const gpu::Texture& texture, const Owed& owed);
    void view(const gpu::Texture& texture, const Owed& owed);

    std::shared_ptr<const ViewPrograms> m_programs;
    Viewer m_viewer;
    Meter m_meter;
    LightCells m_cells;
    std::set<Kind> m_met;
    std::deque<Owed> m_owed;
    std::optional<Seen> m_seen;
};
