#pragma once

#include "model/plan/pass_switches.h"
#include "model/plan/plan.h"

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

/// Whether a frame may be partially redrawn, or drawn in slices while the previous one is
/// displayed. With `never`, a picture may be overwritten after its last read in the frame.
enum class Redraws { possible, never };

/// What a frame depends on besides look and values.
struct FrameSettings {
    Extent viewport = {};              // of the picture, px
    Extent source = {};                // px
    std::vector<PassRun> runs = {};    // by pass; passes without an entry are drawn
    std::vector<bool> displayed = {};  // by pass; empty: all
    Redraws redraws = Redraws::possible;
};

/// What the frames of a look consist of: passes and their order, targets, values. Without GL.
/// Passes are given by their index in the look.
class FrameGraph {
public:
    /// `largest_side` of a texture, px.
    FrameGraph(Look look, int largest_side)
        : m_look(std::move(look)), m_largest_side(largest_side) {}

    const Look& look() const { return m_look; }
    const Values& values() const { return m_values; }
    const FrameSettings& settings() const { return m_settings; }
    /// Without targets until the first set_plan().
    const Plan& plan() const { return m_plan; }
    /// The passes in drawing order.
    const std::vector<std::size_t>& order() const { return m_order; }

    /// The plan with other settings, or for an edited look with these settings.
    Result<Plan> plan_for(const FrameSettings& settings) const;
    Result<Plan> plan_for(const Look& edited) const;

    /// Returns the sorted names of the parameters that changed.
    std::vector<std::string> set_values(const Values& values);
    void set_settings(FrameSettings settings);
    void set_plan(Plan plan);
    /// Replaces the look with an edited one. If it has other passes, all are displayed.
    void set_look(Look look);
    /// Sets which inputs of each pass its program reads.
    void set_read_inputs(std::vector<std::vector<bool>> read) { m_read_inputs = std::move(read); }

    PassRun run_of(std::size_t pass) const;
    /// The pass whose target it is drawn onto, else itself.
    std::size_t host_of(std::size_t pass) const { return m_plan.targets[pass].onto.value_or(pass); }
    /// Whether the next pass is drawn onto the same target.
    bool is_followed_onto(std::size_t pass) const;
    /// Draws per frame.
    int repeats_of(std::size_t pass) const;
    /// After how many samples an accumulating pass has converged. 0: it restarts with every frame.
    /// nullopt: never.
    std::optional<int> samples_to_converge(std::size_t pass) const;
    /// The smallest spot of a pass that draws segments.
    const BeamSpot& spot_of(std::size_t pass) const;
    /// Whether later frames read its picture.
    bool is_read_later(std::size_t pass) const;
    /// Whether another pass may have overwritten its picture at the end of the frame.
    bool is_overwritten(std::size_t pass) const;

private:
    PlanTerms terms(const FrameSettings& settings, const Look& look) const;

    Look m_look;
    int m_largest_side;
    Values m_values;
    FrameSettings m_settings;
    Plan m_plan;
    std::vector<std::size_t> m_order;
    std::vector<std::vector<bool>> m_read_inputs;
    mutable std::vector<std::optional<BeamSpot>> m_spots;  // for the current values and sizes
};
