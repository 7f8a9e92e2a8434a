#include "io/control/udp_port.h"

#include <fmt/format.h>

#include <arpa/inet.h>
#include <array>
#include <cerrno>
#include <netinet/in.h>
#include <sys/socket.h>
#include <system_error>

namespace {
sockaddr_in local_address(int port) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(static_cast<std::uint16_t>(port));
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    return address;
}
}  // namespace

Result<UdpPort> UdpPort::open(int port) {
    const auto refused = [port](int reason) {
        return fail({{},
                     0,
                     reason == EADDRINUSE
                         ? fmt::format("can't listen on port {}: another program is using it", port)
                         : fmt::format("can't listen on port {}: {}", port,
                                       std::generic_category().message(reason))});
    };
    Descriptor socket(::socket(AF_INET, SOCK_DGRAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0));
    if (!socket.is_open())
        return refused(errno);
    sockaddr_in address = local_address(port);
    socklen_t size = sizeof(address);
    auto* const any = reinterpret_cast<sockaddr*>(&address);
    if (::bind(socket.get(), any, size) != 0 || ::getsockname(socket.get(), any, &size) != 0)
        return refused(errno);
    return UdpPort(std::move(socket), ntohs(address.sin_port));
}

std::optional<std::vector<std::uint8_t>> UdpPort::take() const {
    constexpr std::size_t largest = 65536;
    std::array<std::uint8_t, largest> buffer;
    const auto size = ::recv(m_socket.get(), buffer.data(), buffer.size(), 0);
    if (size < 0)
        return std::nullopt;
    return std::vector<std::uint8_t>(buffer.begin(), buffer.begin() + size);
}
