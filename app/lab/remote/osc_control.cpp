#include "lab/remote/osc_control.h"

#include <utility>

Result<void> OscControl::listen(int port, NetworkReach reach) {
    m_watch(-1);
    m_port.reset();
    m_messages.clear();
    m_next = 0;
    m_networks.clear();
    if (port == 0)
        return {};
    auto opened = UdpPort::open(port, reach);
    if (!opened)
        return fail(opened.error());
    m_port = std::move(*opened);
    m_reach = reach;
    if (reach == NetworkReach::local_network)
        m_networks = local_networks();
    m_watch(m_port->descriptor());
    return {};
}

void OscControl::set_watch(std::function<void(int)> watch) {
    m_watch = std::move(watch);
    if (m_port)
        m_watch(m_port->descriptor());
}

void OscControl::begin_update(double now_seconds) {
    constexpr double seconds_between = 5.0;
    m_packets = 0;
    if (!m_port || m_reach != NetworkReach::local_network ||
        now_seconds - m_networks_seconds < seconds_between)
        return;
    m_networks = local_networks();
    m_networks_seconds = now_seconds;
}

// Limited per update, so that an endless sender cannot block the picture.
std::optional<ReceivedOsc> OscControl::take(std::vector<RejectedPacket>& rejected) {
    constexpr std::size_t max_packets = 100;
    if (!m_port)
        return std::nullopt;
    while (!has_more()) {
        const auto packet = m_packets++ < max_packets ? m_port->take() : std::nullopt;
        if (!packet)
            return std::nullopt;
        read(*packet, rejected);
    }
    return ReceivedOsc{std::move(m_messages[m_next++]), m_sender};
}

void OscControl::read(const UdpPacket& packet, std::vector<RejectedPacket>& rejected) {
    m_messages.clear();
    m_next = 0;
    m_sender = packet.sender;
    if (!is_local(packet.sender.host, m_networks)) {
        rejected.push_back({packet.sender, "the sender is outside the local network"});
        return;
    }
    auto messages = parse_osc(packet.bytes);
    if (messages)
        m_messages = std::move(*messages);
    else
        rejected.push_back({packet.sender, messages.error().front().message});
}

Result<void> OscControl::send(const OscMessage& message, const UdpAddress& to) const {
    if (!m_port)
        return fail({{}, 0, "OSC is off"});
    return m_port->send(osc_packet(message), to);
}
