#include "io/control/midi_clock_input.h"

#include <chrono>

double MidiClockInput::now() {
    const auto since = std::chrono::steady_clock::now().time_since_epoch();
    return std::chrono::duration<double>(since).count();
}

bool MidiClockInput::is_clock_message(std::span<const unsigned char> message) {
    constexpr unsigned char song_position = 0xF2;
    constexpr unsigned char first_real_time = 0xF8;
    return !message.empty() &&
           (message.front() == song_position || message.front() >= first_real_time);
}

void MidiClockInput::receive(std::span<const unsigned char> message, std::size_t device,
                             double seconds) {
    const std::lock_guard lock(m_mutex);
    if (device != m_device) {
        if (m_clock.is_present(seconds))
            return;
        m_clock = {};
        m_device = device;
    }
    for (const unsigned char byte : message)
        m_clock.take(byte, seconds);
}

MidiClock MidiClockInput::clock() const {
    const std::lock_guard lock(m_mutex);
    return m_clock;
}
