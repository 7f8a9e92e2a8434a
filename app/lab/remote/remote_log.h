#pragma once

#include "io/control/osc_packet.h"

#include <cstddef>
#include <deque>
#include <string>
#include <vector>

/// A message that was rejected. Control characters in its texts are escaped.
struct RejectedMessage {
    double seconds = 0.0;  // time of day, local, since midnight
    std::string address;
    std::string value;   // its arguments: `0.5 "Amber P3"`
    std::string sender;  // "192.168.1.20" or "MIDI"
    std::string reason;
    std::size_t count = 1;  // equal ones; time and value are of the last

    bool operator==(const RejectedMessage&) const = default;
};

/// The arguments of a message as text.
std::string arguments_text(const OscMessage& message);

/// "14:05:09".
std::string time_of_day_text(double seconds);

/// Counts remote messages, and keeps the last rejected ones.
class RemoteLog {
public:
    void accept() { ++m_accepted; }
    /// Equal messages (address, sender, reason) are one entry. The oldest of 100 entries is
    /// dropped.
    void reject(RejectedMessage message);
    void clear() { m_messages.clear(); }

    std::size_t accepted() const { return m_accepted; }
    std::size_t rejected() const { return m_rejected; }
    /// The rejected ones, the last first.
    const std::deque<RejectedMessage>& messages() const { return m_messages; }
    /// One line per message, with its fields separated by tabs. The oldest first.
    std::string text() const;

private:
    std::size_t m_accepted = 0;
    std::size_t m_rejected = 0;
    std::deque<RejectedMessage> m_messages;
};
