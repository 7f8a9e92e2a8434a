#pragma once

#include "io/control/osc_packet.h"
#include "io/control/udp_port.h"
#include "lab/remote/remote_hand.h"

#include <optional>
#include <string>
#include <vector>

/// What a message asks of a look: `/afterglow/NAME` and a number, as many as a vector has, or a
/// text as a person would type it.
Result<RemoteTurn> turn_of(const OscMessage& message, const Look& look);

/// Lets other programs on this machine turn parameters by Open Sound Control.
class OscControl {
public:
    /// 0: listens no more. On failure it does not listen.
    Result<void> listen(int port);
    bool is_listening() const { return m_port.has_value(); }
    /// -1 when it does not listen.
    int descriptor() const { return m_port ? m_port->descriptor() : -1; }
    int port() const { return m_port ? m_port->number() : 0; }

    /// Takes in what has come, at most 1000 messages a call; the others wait for the next one.
    /// Null: nothing is open to be turned.
    void update(Document* document, RemoteHand& hand, double now_seconds);

    /// Whether messages wait for the next call.
    bool has_more() const { return m_next < m_messages.size(); }

    std::size_t turned() const { return m_turned; }
    std::size_t refused() const { return m_refused; }
    /// Why the last one was refused; "" for none.
    const std::string& problem() const { return m_problem; }

private:
    void read(const std::vector<std::uint8_t>& packet);
    void take(const OscMessage& message, Document* document, RemoteHand& hand, double now_seconds);
    void refuse(const Diagnostics& reasons);

    std::optional<UdpPort> m_port;
    std::size_t m_turned = 0;   // messages
    std::size_t m_refused = 0;  // packets and messages
    std::string m_problem;
    std::vector<OscMessage> m_messages;  // of the latest packet
    std::size_t m_next = 0;              // of them that is to be taken
};
