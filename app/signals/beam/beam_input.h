#pragma once

#include "model/plan/beam.h"
#include "signals/beam/beam_input_points.h"
#include "signals/signal/clock.h"

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <deque>
#include <limits>
#include <mutex>
#include <span>

/// A beam from another program: a queue from the reading thread to the drawing thread. The sender
/// blocks when it is too far ahead, so the queue stays short.
class BeamInput {
public:
    enum class Pace {
        live,     // time does not wait for the sender: late points are drawn on arrival
        waiting,  // drawing waits for the sender: the same points give the same beam
    };
    explicit BeamInput(Pace pace, double start = 0.0) : m_pace(pace), m_now(start), m_end(start) {}

    /// Drawing waits at most this long for a point, then continues without the sender. The default
    /// is no limit.
    void set_timeout(double seconds) { m_timeout_seconds = seconds; }
    /// Whether the wait timed out.
    bool has_timed_out() const { return m_has_timed_out; }

    // For the sender's thread.
    void append(std::span<const BeamInputPoint> points);
    /// End of input; drawing no longer waits.
    void end();

    // For the drawing thread.
    void trace(const TimeSpan& span, Beam& beam);
    /// Discards all points. The next point comes after this time.
    void start_at(double seconds);
    /// Stops drawing: neither thread waits.
    void close();

private:
    struct Position {
        float x = 0.0f;
        float y = 0.0f;
    };
    /// The path to a point. Its end time is the start time of the next leg.
    struct Leg {
        double begin = 0.0;
        double seconds = 0.0;
        Position from;
        Position to;
        float current = 0.0f;
        BeamTint tint = {};

        double end() const { return begin + seconds; }
    };

    void append_one(const BeamInputPoint& point);
    void forget_old();
    void wait_for_points(std::unique_lock<std::mutex>& lock, double until);
    void trace_leg(const Leg& leg, const TimeSpan& span, Beam& beam) const;

    const Pace m_pace;
    std::mutex m_mutex;
    std::condition_variable m_changed;
    std::deque<Leg> m_legs;
    double m_now;  // s, drawn up to here
    double m_end;  // s, end of the last leg
    Position m_last;
    bool m_has_last = false;
    bool m_has_tints = false;  // some point has a colour
    bool m_has_ended = false;
    std::atomic<bool> m_has_timed_out = false;
    double m_timeout_seconds = std::numeric_limits<double>::infinity();
    bool m_is_closed = false;
};
