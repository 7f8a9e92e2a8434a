#pragma once

#include "io/control/osc_packet.h"
#include "io/control/udp_port.h"

#include <doctest/doctest.h>

#include <memory>
#include <string>
#include <vector>

/// Another program: it sends OSC from its own UDP port and receives the replies.
class RemotePeer {
public:
    RemotePeer() : m_port(*UdpPort::open(0)) {}

    int port() const { return m_port.number(); }
    void send_bytes(int port, const std::vector<std::uint8_t>& bytes) const {
        constexpr std::uint32_t loopback = 0x7f000001;
        REQUIRE(m_port.send(bytes, {loopback, port}).has_value());
    }
    void send(int port, const std::string& address,
              std::vector<OscMessage::Argument> arguments = {}) const {
        send_bytes(port, osc_packet({address, std::move(arguments)}));
    }
    /// The received messages.
    std::vector<OscMessage> received() const {
        std::vector<OscMessage> messages;
        while (const auto packet = m_port.take()) {
            const auto read = parse_osc(packet->bytes);
            REQUIRE(read.has_value());
            messages.insert(messages.end(), read->begin(), read->end());
        }
        return messages;
    }

private:
    UdpPort m_port;
};

/// A port that is free now.
inline int free_port() {
    const auto port = UdpPort::open(0);
    REQUIRE(port.has_value());
    return port->number();
}
