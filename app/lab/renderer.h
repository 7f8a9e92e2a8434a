#pragma once

#include "graph/executor.h"
#include "lab/player.h"

#include <functional>
#include <memory>
#include <optional>
#include <vector>

/// How far showing a paused picture anew has come.
struct Replay {
    std::size_t done = 0;   // frames
    std::size_t total = 0;  // frames
    bool is_running() const { return done < total; }
};

/// Draws the open look: frame by frame while time flows, and again from its past while it rests.
class Renderer {
public:
    Renderer(Look look, Programs programs) : m_executor(std::move(look), std::move(programs)) {}

    /// An edited look; what drew a moment ago keeps its history.
    Result<void> replace(Look look, Programs programs) {
        return m_executor.replace(std::move(look), std::move(programs));
    }
    void set_values(const Values& values) { m_executor.set_values(values); }
    Result<void> resize(Extent picture, Extent source) {
        return m_executor.resize(picture, source);
    }
    /// As it was last asked for, with sizes that depend on values as these are now.
    Result<void> resize_again() { return m_executor.resize_again(); }
    Result<void> set_source(const Picture& picture) { return m_executor.set_source(picture); }
    Result<void> set_image(const std::string& name, const Picture& picture) {
        return m_executor.set_image(name, picture);
    }
    void set_mouse(double x, double y);  // px from bottom left
    /// How long a frame may take its accumulating passes; the rest is left to the next ones.
    void set_patience(double seconds) { m_patience_seconds = seconds; }
    /// What drives the look is another: accumulating passes start anew.
    void restart_samples() { m_executor.restart_samples(); }

    void draw(const PlayedFrame& frame, const Beam& beam);
    /// A frame that nobody will look at: only what later frames are made of is drawn.
    void draw_unseen(const PlayedFrame& frame, const Beam& beam);
    void clear_history() { m_executor.clear_history(); }

    /// Draws the present frame again; only the passes that the change reaches.
    void redraw(const Player& player, const std::vector<bool>& passes);
    /// Begins to draw the latest `frames` frames of the player again from nothing.
    void start_replay(const Player& player, std::size_t frames);
    /// Called before a frame of the past is drawn again, to bring what it shows.
    using BeforeFrame = std::function<void(const PlayedFrame&)>;
    /// Goes on with the replay for about `seconds`; true when it has just ended.
    bool continue_replay(const Player& player, double seconds, const BeforeFrame& before);
    void cancel_replay() { m_replay = {}; }
    const Replay& replay() const { return m_replay; }

    /// Also lets it look whether the driver knows more pass times.
    std::vector<double> pass_milliseconds() { return m_executor.pass_milliseconds(); }
    /// As of the last frame; the driver is some frames behind.
    const std::vector<double>& latest_pass_milliseconds() const { return m_pass_milliseconds; }
    /// Points of the beam in the last frame.
    std::size_t point_count() const { return m_point_count; }
    /// Of the latest frames, smoothed: how long the passes that draw points take for each second of
    /// the signal; 0 where the driver tells no times.
    double beam_seconds_a_second() const { return m_beam_cost; }
    const Executor& executor() const { return m_executor; }
    /// Smoothed wall time of a frame's drawing calls, in seconds.
    double frame_seconds() const { return m_frame_seconds; }

private:
    void note_beam_cost(const PlayedFrame& played);
    Frame frame_of(const PlayedFrame& played, const Beam& beam) const;

    Executor m_executor;
    std::array<double, 2> m_mouse{};
    double m_patience_seconds = 0.0;
    std::vector<double> m_pass_milliseconds;
    std::size_t m_point_count = 0;
    double m_beam_cost = 0.0;
    Replay m_replay;
    std::size_t m_replay_first = 0;
    double m_frame_seconds = 1.0 / 60.0;
};
