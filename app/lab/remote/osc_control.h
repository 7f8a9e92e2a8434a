#pragma once

#include "io/control/osc_packet.h"
#include "io/control/udp_port.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

/// A message and its sender.
struct ReceivedOsc {
    OscMessage message;
    UdpAddress sender;
};

/// A packet that could not be read, and its sender.
struct RejectedPacket {
    UdpAddress sender;
    std::string reason;
};

/// Receives and sends Open Sound Control messages.
class OscControl {
public:
    /// Opens the port; 0 closes it. If it fails, no port is open.
    Result<void> listen(int port, NetworkReach reach = NetworkReach::this_machine);
    bool is_listening() const { return m_port.has_value(); }
    /// `watch` gets the descriptor of the open port, now and after each listen(), and -1 before a
    /// port closes: a thread that still waited for messages would keep the port in use.
    void set_watch(std::function<void(int descriptor)> watch);
    int port() const { return m_port ? m_port->number() : 0; }
    NetworkReach reach() const { return m_reach; }
    /// The networks that senders can be in; empty if only this machine is accepted.
    const std::vector<LocalNetwork>& networks() const { return m_networks; }

    /// Call it in every update, before take(). Follows changes of the networks. The time is of a
    /// clock that never stops.
    void begin_update(double now_seconds);
    /// The next message of up to 100 packets per update; nullopt: none. Packets that cannot be
    /// read, or that come from outside, are added to `rejected`.
    std::optional<ReceivedOsc> take(std::vector<RejectedPacket>& rejected);
    /// Whether messages wait for the next update.
    bool has_more() const { return m_next < m_messages.size(); }

    /// Sends a reply from the open port.
    Result<void> send(const OscMessage& message, const UdpAddress& to) const;

private:
    void read(const UdpPacket& packet, std::vector<RejectedPacket>& rejected);

    std::optional<UdpPort> m_port;
    NetworkReach m_reach = NetworkReach::this_machine;
    std::function<void(int)> m_watch = [](int) {};
    std::vector<LocalNetwork> m_networks;
    double m_networks_seconds = 0.0;     // time of their last update
    std::vector<OscMessage> m_messages;  // of the latest packet
    std::size_t m_next = 0;              // index of the next message
    UdpAddress m_sender;                 // of the latest packet
    std::size_t m_packets = 0;           // taken in this update
};
