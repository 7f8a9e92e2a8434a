#pragma once

#include <cstdint>
#include <deque>
#include <optional>

/// Reads the tempo and position of a MIDI clock: 24 clock bytes per quarter note, start, continue,
/// stop and song position (MIDI 1.0 Detailed Specification, "System Real Time Messages"). A line
/// fitted to the last four beats filters jitter.
class MidiClock {
public:
    static constexpr double ticks_per_beat = 24.0;

    /// The next byte of the stream, received at this time in seconds. Other messages are skipped.
    void take(std::uint8_t byte, double seconds);

    /// Whether clock bytes arrive: the last one is less than half a second old.
    bool is_present(double now_seconds) const;
    /// Whether the sender plays: started or continued, and not stopped.
    bool is_running() const { return m_is_running; }
    /// Beats per minute; nullopt: fewer than 12 clock bytes since the clock appeared.
    std::optional<double> bpm() const;
    /// The position in quarter notes since the start of the song, at a time near the present. While
    /// stopped, the position where it stopped.
    double beats_at(double seconds) const;

private:
    struct Tick {
        double number = 0.0;   // since the clock appeared
        double seconds = 0.0;  // when it arrived
    };
    /// Time of a tick: seconds = offset + number * seconds_per_tick.
    struct Line {
        double offset = 0.0;
        double seconds_per_tick = 0.0;
    };

    void tick(double seconds);
    void take_data(std::uint8_t byte);
    void place(double position);
    std::optional<Line> line() const;

    std::deque<Tick> m_ticks;
    double m_count = 0.0;     // ticks since the clock appeared
    double m_start = 0.0;     // the tick number of position 0, while running
    double m_position = 0.0;  // ticks of the song while stopped; the next tick while running begins
    bool m_is_running = false;
    bool m_begins = false;  // the next tick is at m_position
    int m_data_left = 0;    // bytes of a song position
    int m_data = 0;
};
