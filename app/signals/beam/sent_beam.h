#pragma once

#include "model/plan/beam.h"
#include "signals/beam/sent_points.h"
#include "signals/signal/clock.h"

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <deque>
#include <limits>
#include <mutex>
#include <span>

/// The beam that another program sends, on its way from the thread that reads to the one that
/// draws. The sender waits while it is well ahead of what is drawn, so little is kept.
class SentBeam {
public:
    enum class Pace {
        live,     // time goes on without the sender: what comes late is drawn when it comes
        waiting,  // drawing waits for the sender: the same points give the same beam
    };
    explicit SentBeam(Pace pace, double start = 0.0) : m_pace(pace), m_now(start), m_end(start) {}

    /// Drawing waits no longer than so many seconds without a point; then it goes on without the
    /// sender. At first it waits for ever.
    void set_patience(double seconds) { m_patience_seconds = seconds; }
    /// Whether that happened.
    bool has_timed_out() const { return m_has_timed_out; }

    // The sender's side.
    void append(std::span<const SentPoint> points);
    /// Nothing more comes; drawing no longer waits.
    void end();

    // The side that draws.
    void trace(const TimeSpan& span, Beam& beam);
    /// Forgets what has come; the next point comes after this time.
    void start_at(double seconds);
    /// Nobody draws any more: neither side waits.
    void close();

private:
    struct Place {
        float x = 0.0f;
        float y = 0.0f;
    };
    /// The way to a point; the time of its end is the next one's begin.
    struct Leg {
        double begin = 0.0;
        double seconds = 0.0;
        Place from;
        Place to;
        float current = 0.0f;
        BeamTint tint = {};

        double end() const { return begin + seconds; }
    };

    void append_one(const SentPoint& point);
    void forget_old();
    void wait_for_points(std::unique_lock<std::mutex>& lock, double until);
    void trace_leg(const Leg& leg, const TimeSpan& span, Beam& beam) const;

    const Pace m_pace;
    std::mutex m_mutex;
    std::condition_variable m_changed;
    std::deque<Leg> m_legs;
    double m_now;  // drawn so far, s
    double m_end;  // of the last leg, s
    Place m_last;
    bool m_has_last = false;
    bool m_has_tints = false;  // some point had a colour
    bool m_has_ended = false;
    std::atomic<bool> m_has_timed_out = false;
    double m_patience_seconds = std::numeric_limits<double>::infinity();
    bool m_is_closed = false;
};
