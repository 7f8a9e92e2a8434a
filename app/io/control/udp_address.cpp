#include "io/control/udp_address.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <ifaddrs.h>
#include <memory>
#include <net/if.h>
#include <netinet/in.h>

namespace {
std::uint32_t host_of(const sockaddr& address) {
    sockaddr_in internet{};
    std::memcpy(&internet, &address, sizeof internet);
    return ntohl(internet.sin_addr.s_addr);
}

bool is_network(const ifaddrs& entry) {
    return entry.ifa_addr && entry.ifa_netmask && entry.ifa_addr->sa_family == AF_INET &&
           (entry.ifa_flags & IFF_UP) != 0 && (entry.ifa_flags & IFF_LOOPBACK) == 0;
}
}  // namespace

std::string host_text(std::uint32_t host) {
    return fmt::format("{}.{}.{}.{}", host >> 24, (host >> 16) & 0xff, (host >> 8) & 0xff,
                       host & 0xff);
}

std::string to_string(const UdpAddress& address) {
    return fmt::format("{}:{}", host_text(address.host), address.port);
}

std::vector<LocalNetwork> local_networks() {
    ifaddrs* first = nullptr;
    if (::getifaddrs(&first) != 0)
        return {};
    const std::unique_ptr<ifaddrs, decltype(&::freeifaddrs)> owner(first, &::freeifaddrs);
    std::vector<LocalNetwork> networks;
    for (const ifaddrs* entry = first; entry; entry = entry->ifa_next)
        if (is_network(*entry))
            networks.push_back(
                {host_of(*entry->ifa_addr), host_of(*entry->ifa_netmask), entry->ifa_name});
    return networks;
}

bool is_local(std::uint32_t host, const std::vector<LocalNetwork>& networks) {
    constexpr std::uint32_t loopback = 127;
    return host >> 24 == loopback || std::ranges::any_of(networks, [host](const LocalNetwork& one) {
               return ((host ^ one.host) & one.mask) == 0;
           });
}
