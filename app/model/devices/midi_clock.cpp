#include "model/devices/midi_clock.h"

#include <algorithm>
#include <cmath>

namespace {
constexpr std::uint8_t song_position = 0xF2;
constexpr std::uint8_t clock_byte = 0xF8;
constexpr std::uint8_t start_byte = 0xFA;
constexpr std::uint8_t continue_byte = 0xFB;
constexpr std::uint8_t stop_byte = 0xFC;
constexpr std::uint8_t first_real_time = 0xF8;
constexpr std::uint8_t first_status = 0x80;
constexpr double clock_timeout = 0.5;  // s; at 20 bpm a tick takes 0.125 s
constexpr std::size_t fit_window = 96;
constexpr std::size_t fewest_ticks = 12;
}  // namespace

void MidiClock::take(std::uint8_t byte, double seconds) {
    if (byte < first_status)
        return take_data(byte);
    if (byte < first_real_time)
        m_data_left = 0;  // another message begins; real-time bytes may be inside one
    switch (byte) {
        case song_position:
            m_data_left = 2;
            m_data = 0;
            break;
        case clock_byte:
            tick(seconds);
            break;
        case start_byte:
            m_is_running = true;
            place(0.0);
            break;
        case continue_byte:
            m_is_running = true;
            place(m_position);
            break;
        case stop_byte:
            if (m_is_running && !m_begins)
                m_position = m_count - m_start;  // the position of the next tick
            m_is_running = false;
            break;
        default:
            break;
    }
}

// 14 bits, the low seven first, in units of six ticks.
void MidiClock::take_data(std::uint8_t byte) {
    if (m_data_left == 0)
        return;
    m_data |= static_cast<int>(byte) << (m_data_left == 2 ? 0 : 7);
    constexpr double ticks_per_unit = 6.0;
    if (--m_data_left == 0)
        place(ticks_per_unit * m_data);
}

void MidiClock::place(double position) {
    m_position = position;
    m_begins = true;
}

void MidiClock::tick(double seconds) {
    const bool is_lost = !m_ticks.empty() && seconds - m_ticks.back().seconds > clock_timeout;
    if (is_lost)
        m_ticks.clear();
    if (m_is_running && m_begins) {
        m_start = m_count - m_position;
        m_begins = false;
    }
    // Four ticks in a row, all early or all late, are a tempo change: the fit restarts with them.
    constexpr std::size_t checked = 4;
    const auto fitted = line();
    m_ticks.push_back({m_count++, seconds});
    if (fitted && m_ticks.size() > fewest_ticks + checked) {
        int early = 0;
        int late = 0;
        for (std::size_t i = m_ticks.size() - checked; i < m_ticks.size(); ++i) {
            const double off = m_ticks[i].seconds -
                               (fitted->offset + m_ticks[i].number * fitted->seconds_per_tick);
            early += off < -0.5 * fitted->seconds_per_tick ? 1 : 0;
            late += off > 0.5 * fitted->seconds_per_tick ? 1 : 0;
        }
        if (std::max(early, late) == static_cast<int>(checked))
            m_ticks.erase(m_ticks.begin(), m_ticks.end() - static_cast<std::ptrdiff_t>(checked));
    }
    if (m_ticks.size() > fit_window)
        m_ticks.pop_front();
}

bool MidiClock::is_present(double now_seconds) const {
    return !m_ticks.empty() && now_seconds - m_ticks.back().seconds < clock_timeout;
}

// Least squares, relative to the last tick for precision.
std::optional<MidiClock::Line> MidiClock::line() const {
    if (m_ticks.size() < fewest_ticks)
        return std::nullopt;
    const Tick& origin = m_ticks.back();
    const auto count = static_cast<double>(m_ticks.size());
    double x = 0.0;
    double y = 0.0;
    double xx = 0.0;
    double xy = 0.0;
    for (const Tick& tick : m_ticks) {
        const double number = tick.number - origin.number;
        const double seconds = tick.seconds - origin.seconds;
        x += number;
        y += seconds;
        xx += number * number;
        xy += number * seconds;
    }
    const double slope = (count * xy - x * y) / (count * xx - x * x);
    if (!(slope > 0.0))
        return std::nullopt;
    return Line{origin.seconds + (y - slope * x) / count - slope * origin.number, slope};
}

std::optional<double> MidiClock::bpm() const {
    const auto fitted = line();
    return fitted ? std::optional(60.0 / (fitted->seconds_per_tick * ticks_per_beat))
                  : std::nullopt;
}

double MidiClock::beats_at(double seconds) const {
    const auto fitted = line();
    if (!m_is_running || m_begins || !fitted)
        return m_position / ticks_per_beat;
    return ((seconds - fitted->offset) / fitted->seconds_per_tick - m_start) / ticks_per_beat;
}
