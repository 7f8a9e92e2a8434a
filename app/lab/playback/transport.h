#pragma once

#include "model/look/subframe.h"
#include "signals/signal/clock.h"

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>

/// A frame on the player's clock.
struct PlayedFrame {
    std::int64_t number = 0;  // from 1 after a restart
    TimeSpan span;
    Subframe subframe = {};
    std::int64_t source_number = 0;  // of its source frame, from 1; 0: as `number`
};

/// Time since the last frame.
struct Elapsed {
    double seconds = 0.0;       // on the clock
    double wall_seconds = 0.0;  // the same at speed 1
    bool skips_excess = false;  // time beyond the longest frame is skipped; otherwise it is dropped
};

/// The clock of the player: its time and speed, and the frames so far.
class Transport {
public:
    bool is_playing() const { return m_is_playing; }
    double speed() const { return m_speed; }
    double time() const { return m_time; }
    std::int64_t frame_number() const { return m_frame; }
    /// The latest frames, oldest first, for replays.
    const std::deque<PlayedFrame>& past() const { return m_past; }
    double longest_frame() const { return m_longest_frame; }
    /// The share of elapsed time that is drawn, over about the last 0.5 s or the last frame if it
    /// was longer. 1: in real time. A single delayed frame does not count.
    double shown_share() const { return m_shown_share; }

    /// The sub-frames of each source frame that begins from now on.
    void set_subframes(int count) { m_subframes = count; }
    void set_playing(bool is_playing) { m_is_playing = is_playing; }
    void set_speed(double speed);  // 0.01 to 4
    /// The longest time that one frame can cover, 1/240 to 1/4 s.
    void set_longest_frame(double seconds);
    /// Makes take_step() return a frame.
    void step() { m_is_stepping = true; }
    /// Starts again without a past, at time 0 with frame 1. `after`: for advance_fixed(), with the
    /// frame after this one. It must be a multiple of the sub-frames of a source frame.
    void restart(std::int64_t after = 0, int subframes = 1);
    void seek(double seconds);
    /// Replaces the past by up to this number of frames of 1/60 s.
    void fill_past(std::size_t frames);
    /// Seeks to the end of a past frame; false: it is not stored.
    bool go_back_to(std::int64_t frame);

    /// The requested frame of 1/60 s, which begins a source frame, once per step(); nullopt: not
    /// requested.
    std::optional<PlayedFrame> take_step();
    /// The frame for the elapsed time, limited to the longest frame; nullopt: no time has elapsed.
    std::optional<PlayedFrame> advance(const Elapsed& elapsed);
    /// The frame up to this time. Skips time before the longest frame; nullopt: nothing is new.
    std::optional<PlayedFrame> advance_to(double end);
    /// The next frame of a fixed frame rate.
    PlayedFrame advance_fixed(double fps);

private:
    PlayedFrame add_frame(double end);

    static constexpr std::size_t frames_remembered = 1 << 18;  // over an hour at 60 fps
    static constexpr double longest_frame_limit = 0.25;        // s

    bool m_is_playing = true;
    bool m_is_stepping = false;
    double m_speed = 1.0;
    double m_time = 0.0;
    std::int64_t m_frame = 0;
    int m_subframes = 1;
    Subframe m_subframe = {};  // of the last frame
    std::int64_t m_source_frame = 0;
    std::deque<PlayedFrame> m_past;
    double m_longest_frame = longest_frame_limit;
    double m_shown_share = 1.0;
    double m_last_share = 1.0;  // of the last frame only
};
