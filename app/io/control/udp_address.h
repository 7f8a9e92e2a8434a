#pragma once

#include <cstdint>
#include <string>
#include <vector>

/// An IPv4 address and a UDP port. The address is a number: 192.168.1.20 is 0xc0a80114.
struct UdpAddress {
    std::uint32_t host = 0;
    int port = 0;

    bool operator==(const UdpAddress&) const = default;
};

/// "192.168.1.20".
std::string host_text(std::uint32_t host);
/// "192.168.1.20:9000".
std::string to_string(const UdpAddress& address);

/// An IPv4 network that this machine is part of.
struct LocalNetwork {
    std::uint32_t host = 0;  // of this machine
    std::uint32_t mask = 0;
    std::string interface = {};

    bool operator==(const LocalNetwork&) const = default;
};

/// The networks of the active interfaces, without the loopback interface. Empty if the machine has
/// no network.
std::vector<LocalNetwork> local_networks();

/// Whether the address is 127.0.0.0/8 or in one of the networks.
bool is_local(std::uint32_t host, const std::vector<LocalNetwork>& networks);
