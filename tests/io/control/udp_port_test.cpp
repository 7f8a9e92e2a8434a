#include "io/control/udp_port.h"

#include <doctest/doctest.h>

namespace {
using Packet = std::vector<std::uint8_t>;

constexpr std::uint32_t loopback = 0x7f000001;
}  // namespace

TEST_CASE("UDP packets are received with their sender, without blocking, and answered") {
    const auto port = UdpPort::open(0);
    const auto other = UdpPort::open(0);
    REQUIRE(port.has_value());
    REQUIRE(other.has_value());
    CHECK_FALSE(port->take().has_value());
    CHECK_FALSE(UdpPort::open(port->number()).has_value());
    for (const Packet& packet : {Packet{1, 2, 3}, Packet{}, Packet(60000, 7)})
        REQUIRE(other->send(packet, {loopback, port->number()}).has_value());
    for (const Packet& packet : {Packet{1, 2, 3}, Packet{}, Packet(60000, 7)}) {
        const auto received = port->take();
        REQUIRE(received.has_value());
        CHECK(received->bytes == packet);
        CHECK(received->sender == UdpAddress{loopback, other->number()});
    }
    CHECK_FALSE(port->take().has_value());
    REQUIRE(port->send(Packet{9}, {loopback, other->number()}).has_value());
    CHECK(other->take()->bytes == Packet{9});
    CHECK_FALSE(other->send(Packet(70000), {loopback, port->number()}).has_value());  // over 64 KiB
}

TEST_CASE("a port for this machine is bound to 127.0.0.1, one for the network to all addresses") {
    // 127.0.0.2 is another address of this machine, which only the second port receives.
    const auto sender = UdpPort::open(0, NetworkReach::local_network);
    const auto own = UdpPort::open(0);
    const auto network = UdpPort::open(0, NetworkReach::local_network);
    REQUIRE(sender.has_value());
    REQUIRE(own.has_value());
    REQUIRE(network.has_value());
    (void)sender->send(Packet{1}, {loopback + 1, own->number()});
    (void)sender->send(Packet{2}, {loopback + 1, network->number()});
    CHECK_FALSE(own->take().has_value());
    CHECK(network->take()->bytes == Packet{2});
}

TEST_CASE("only senders in the networks of this machine are local") {
    const std::vector<LocalNetwork> home{{0xc0a80114, 0xffffff00, "wlan0"}};  // 192.168.1.20/24
    CHECK(is_local(0xc0a80101, home));
    CHECK(is_local(0xc0a801ff, home));
    CHECK_FALSE(is_local(0xc0a80201, home));  // 192.168.2.1
    CHECK_FALSE(is_local(0x08080808, home));
    CHECK(is_local(0x7f000002, home));
    CHECK_FALSE(is_local(0xc0a80101, {}));
    CHECK(host_text(0xc0a80114) == "192.168.1.20");
    CHECK(to_string(UdpAddress{0xc0a80114, 9000}) == "192.168.1.20:9000");
}

TEST_CASE("the networks of this machine contain its own addresses and not the loopback") {
    for (const LocalNetwork& network : local_networks()) {
        CAPTURE(network.interface);
        CHECK((network.host >> 24) != 127);
        CHECK(is_local(network.host, {network}));
    }
}
