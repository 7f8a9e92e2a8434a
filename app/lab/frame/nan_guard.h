#pragma once

#include "graph/executor/nan_watch.h"
#include "lab/frame/workspace.h"

#include <memory>
#include <optional>

/// The user's action for NaN and infinity.
enum class NonFiniteAction {
    clear,   // clears the history
    clamp,   // replaces them by finite values
    ignore,  // ignores them until the look changes
};

/// Pauses when a pass writes NaN or infinity, and finds the pass that wrote it first.
class NanGuard {
public:
    explicit NanGuard(Workspace& work) : m_work(work) {}

    /// The pixel that paused the picture; nullopt: none.
    const std::optional<NonFinitePixel>& found() const { return m_found; }
    void set_action(NonFiniteAction set_action);
    /// Without a user to ask, the values are clamped, and the first one is reported.
    void set_unattended(bool is_unattended) { m_is_unattended = is_unattended; }

    /// Call before a frame is drawn: sets the detection of the executor.
    void prepare();
    /// Call after a frame was drawn.
    void update();
    /// Call after a change that may have removed the cause.
    void recheck(const Redraw& redraw);
    /// Call when the clock restarts.
    void restart() { m_found.reset(); }
    /// Whether the GPU has not finished its checks.
    bool is_waiting() const { return m_watch->is_waiting(); }
    /// Call when another look is opened.
    void open();
    /// Call when the look was edited.
    void reset();

private:
    void stop_at(const NonFinitePixel& found);

    Workspace& m_work;
    std::shared_ptr<NanWatch> m_watch = std::make_shared<NanWatch>();  // of the picture
    std::optional<NonFinitePixel> m_found;
    std::optional<NonFiniteAction> m_action;  // until the look changes
    bool m_is_unattended = false;
    bool m_was_reported = false;
    bool m_plays_after = false;  // when another value or text removes the cause
};
