#pragma once

#include "base/diagnostic.h"
#include "io/system/descriptor.h"

#include <cstdint>
#include <optional>
#include <vector>

/// A UDP port that receives packets only from programs on this machine (127.0.0.1).
class UdpPort {
public:
    /// 1 .. 65535; 0: any free port.
    static Result<UdpPort> open(int port);

    int number() const { return m_number; }
    /// Becomes readable when a packet has been received.
    int descriptor() const { return m_socket.get(); }
    /// The next received packet; nullopt if none is queued. Never waits.
    std::optional<std::vector<std::uint8_t>> take() const;

private:
    UdpPort(Descriptor socket, int number) : m_socket(std::move(socket)), m_number(number) {}

    Descriptor m_socket;
    int m_number;
};
