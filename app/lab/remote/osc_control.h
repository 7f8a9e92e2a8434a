#pragma once

#include "io/control/osc_packet.h"
#include "io/control/udp_port.h"
#include "lab/remote/remote_edits.h"

#include <optional>
#include <string>
#include <vector>

/// Parses a message `/afterglow/NAME` with one number per component, or with a text as the user
/// would type it.
Result<RemoteChange> change_of(const OscMessage& message, const Look& look);

/// Lets other programs on this machine set parameters by Open Sound Control.
class OscControl {
public:
    /// Opens the port; 0 closes it. If it fails, no port is open.
    Result<void> listen(int port);
    bool is_listening() const { return m_port.has_value(); }
    /// -1: not open.
    int descriptor() const { return m_port ? m_port->descriptor() : -1; }
    int port() const { return m_port ? m_port->number() : 0; }

    /// Applies up to 1000 received messages; the remaining ones wait for the next call. Null: no
    /// look is open.
    void update(Document* document, RemoteEdits& edits, double now_seconds);

    /// Whether messages wait for the next call.
    bool has_more() const { return m_next < m_messages.size(); }

    std::size_t applied() const { return m_applied; }
    std::size_t refused() const { return m_refused; }
    /// The last reason for refusal; "": not refused.
    const std::string& problem() const { return m_problem; }

private:
    void read(const std::vector<std::uint8_t>& packet);
    void take(const OscMessage& message, Document* document, RemoteEdits& edits,
              double now_seconds);
    void refuse(const Diagnostics& reasons);

    std::optional<UdpPort> m_port;
    std::size_t m_applied = 0;  // messages
    std::size_t m_refused = 0;  // packets and messages
    std::string m_problem;
    std::vector<OscMessage> m_messages;  // of the latest packet
    std::size_t m_next = 0;              // index of the next message
};
