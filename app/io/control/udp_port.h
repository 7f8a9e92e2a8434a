#pragma once

#include "base/diagnostic.h"
#include "io/control/udp_address.h"
#include "io/system/descriptor.h"
#include "model/devices/network_reach.h"

#include <chrono>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

/// A received packet and its sender.
struct UdpPacket {
    std::vector<std::uint8_t> bytes;
    UdpAddress sender;
};

/// A UDP port. It receives packets from programs on this machine (127.0.0.1), or from all networks
/// of this machine; then the caller checks the senders.
class UdpPort {
public:
    /// 1 .. 65535; 0: any free port.
    static Result<UdpPort> open(int port, NetworkReach reach = NetworkReach::this_machine);

    int number() const { return m_number; }
    /// Becomes readable when a packet has been received.
    int descriptor() const { return m_socket.get(); }
    /// The next received packet; nullopt if none is queued. Never waits.
    std::optional<UdpPacket> take() const;
    /// The next packet; nullopt if none comes within the time.
    std::optional<UdpPacket> take_within(std::chrono::milliseconds longest) const;
    /// Sends a packet from this port. Never waits; a packet can get lost without an error.
    Result<void> send(std::span<const std::uint8_t> bytes, const UdpAddress& to) const;

private:
    UdpPort(Descriptor socket, int number) : m_socket(std::move(socket)), m_number(number) {}

    Descriptor m_socket;
    int m_number;
};
