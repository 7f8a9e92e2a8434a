#pragma once

#include "graph/executor/frame_graph.h"

#include <cstddef>
#include <optional>
#include <vector>

/// The progress of an accumulating pass.
struct Samples {
    int held = 0;
    std::optional<int> enough = std::nullopt;  // 0: restarts with every frame

    bool operator==(const Samples&) const = default;
};

/// How many samples the accumulating passes of a look have taken.
class AccumulatedSamples {
public:
    /// `graph` must outlive it.
    explicit AccumulatedSamples(const FrameGraph& graph) : m_graph(graph) {}

    /// Discards all samples, or those of the passes that depend on `changed` passes. False if no
    /// pass depends on them.
    void restart();
    bool restart(const std::vector<bool>& changed);

    int held(std::size_t pass) const { return pass < m_held.size() ? m_held[pass] : 0; }
    void add(std::size_t pass) { ++m_held[pass]; }
    /// Of the last accumulating pass; nullopt without one.
    std::optional<Samples> last() const;
    /// Of the last accumulating pass before this one.
    int before(std::size_t pass) const;
    /// Whether a pass that accumulates needs no more samples.
    bool has_converged(std::size_t pass) const;
    /// Samples to take in this frame. With a time limit, only those that fit: of `seconds_each`, or
    /// one while that is 0. Restarts if the pass does so with every frame.
    int begin_frame(std::size_t pass, double sample_budget_seconds, double seconds_each);

    /// Remembers the samples of the last whole frame.
    void note_frame();
    /// Drops the samples since then; all, if the picture that they were added to is lost.
    void drop_frame(bool is_picture_lost);

private:
    const FrameGraph& m_graph;
    std::vector<int> m_held;   // by pass
    std::vector<int> m_whole;  // after the last whole frame
};
