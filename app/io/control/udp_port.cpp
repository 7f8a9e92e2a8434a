#include "io/control/udp_port.h"

#include <fmt/format.h>

#include <arpa/inet.h>
#include <array>
#include <cerrno>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <system_error>

namespace {
sockaddr_in internet_address(const UdpAddress& from) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(static_cast<std::uint16_t>(from.port));
    address.sin_addr.s_addr = htonl(from.host);
    return address;
}

std::string system_error_text(int reason) {
    return std::generic_category().message(reason);
}
}  // namespace

Result<UdpPort> UdpPort::open(int port, NetworkReach reach) {
    const auto refused = [port](int reason) {
        return fail(
            {{},
             0,
             reason == EADDRINUSE
                 ? fmt::format("can't listen on port {}: another program is using it", port)
                 : fmt::format("can't listen on port {}: {}", port, system_error_text(reason))});
    };
    Descriptor socket(::socket(AF_INET, SOCK_DGRAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0));
    if (!socket.is_open())
        return refused(errno);
    const bool is_open_to_network = reach == NetworkReach::local_network;
    sockaddr_in address =
        internet_address({is_open_to_network ? INADDR_ANY : INADDR_LOOPBACK, port});
    socklen_t size = sizeof(address);
    auto* const any = reinterpret_cast<sockaddr*>(&address);
    if (::bind(socket.get(), any, size) != 0 || ::getsockname(socket.get(), any, &size) != 0)
        return refused(errno);
    return UdpPort(std::move(socket), ntohs(address.sin_port));
}

std::optional<UdpPacket> UdpPort::take() const {
    constexpr std::size_t largest = 65536;
    std::array<std::uint8_t, largest> buffer;
    sockaddr_in sender{};
    socklen_t sender_size = sizeof(sender);
    const auto size = ::recvfrom(m_socket.get(), buffer.data(), buffer.size(), 0,
                                 reinterpret_cast<sockaddr*>(&sender), &sender_size);
    if (size < 0)
        return std::nullopt;
    return UdpPacket{{buffer.begin(), buffer.begin() + size},
                     {ntohl(sender.sin_addr.s_addr), ntohs(sender.sin_port)}};
}

std::optional<UdpPacket> UdpPort::take_within(std::chrono::milliseconds longest) const {
    pollfd wanted{m_socket.get(), POLLIN, 0};
    return ::poll(&wanted, 1, static_cast<int>(longest.count())) > 0 ? take() : std::nullopt;
}

Result<void> UdpPort::send(std::span<const std::uint8_t> bytes, const UdpAddress& to) const {
    const sockaddr_in address = internet_address(to);
    const auto sent = ::sendto(m_socket.get(), bytes.data(), bytes.size(), 0,
                               reinterpret_cast<const sockaddr*>(&address), sizeof(address));
    if (sent < 0)
        return fail(
            {{}, 0, fmt::format("can't send to {}: {}", to_string(to), system_error_text(errno))});
    return {};
}
