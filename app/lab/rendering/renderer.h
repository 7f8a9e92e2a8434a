#pragma once

#include "lab/rendering/executors.h"
#include "lab/rendering/frame_times.h"
#include "lab/rendering/replay.h"
#include "lab/rendering/slicing.h"

#include <optional>
#include <vector>

/// Draws the open look in the window: frames that would block it are drawn in slices, one per
/// update.
class Renderer {
public:
    explicit Renderer(Executor picture) : m_executors(std::move(picture)) {}
    Renderer(const Renderer&) = delete;
    Renderer& operator=(const Renderer&) = delete;

    Executors& executors() { return m_executors; }
    const Executors& executors() const { return m_executors; }
    /// Of the picture.
    const Executor& executor() const { return m_executors.picture(); }
    Replay& replay() { return m_replay; }
    const Replay& replay() const { return m_replay; }
    const FrameTimes& times() const { return m_times; }

    const InputState& input_state() const { return m_executors.inputs().input_state; }
    /// Changes mouse and keys for the next frames.
    void change_input_state(const std::function<void(InputState&)>& change);
    /// Draws slow frames in slices of about this time. The draws below begin a frame, and
    /// continue_frame() continues it. 0: frames are drawn whole.
    void set_slice(double seconds) { m_slicing.set_slice(seconds); }
    void draw(const PlayedFrame& frame, const Beam& beam);
    /// A frame that is not displayed: draws only the passes that later frames depend on.
    void draw_unseen(const PlayedFrame& frame, const Beam& beam);
    /// Redraws these passes of the current frame.
    void redraw(const Player& player, const std::vector<bool>& passes);
    /// Values, source and images must not change meanwhile.
    bool has_unfinished_frame() const { return m_unfinished.has_value(); }
    /// Continues for a slice, or about `seconds`; true when the frame is complete.
    bool continue_frame() { return continue_frame(m_slicing.slice_seconds()); }
    bool continue_frame(double seconds);
    void drop_frame();
    /// Whether a frame was dropped before it was complete, and none was drawn since. Forgets it.
    bool take_dropped_frame() { return std::exchange(m_was_dropped, false); }
    void clear_history();
    /// Call if look, programs or targets were replaced.
    void reset();

    /// Whether a frame has been completed.
    bool has_drawn() const { return m_has_drawn; }
    /// Whether executor() holds a complete picture. During a frame this is usually the previous
    /// one.
    bool has_whole_picture() const;
    /// Whether the next frame would be the same; see FrameDrawer.
    bool has_converged() const;

private:
    /// A frame that is drawn in slices.
    struct Unfinished {
        bool is_again = false;
        bool is_whole = false;  // draws all passes for the first time
        PlayedFrame played = {};
        std::size_t points = 0;
        double seconds = 0.0;  // time so far
    };

    Slices begin_slices(const Unfinished& unfinished);
    void note_whole(const PlayedFrame& played, std::size_t points, double seconds);
    void finish_frame();
    void end_unfinished();
    void note_mouse();

    Executors m_executors;
    Replay m_replay{*this};
    FrameTimes m_times;
    Slicing m_slicing;
    std::optional<Unfinished> m_unfinished;
    bool m_is_double_buffered = false;  // the previous picture is displayed meanwhile
    bool m_has_new_mouse = false;       // since the unfinished frame began
    bool m_was_dropped = false;
    bool m_has_drawn = false;
    bool m_holds_picture = false;  // not cleared since the last complete frame
};
