#pragma once

#include "io/osc_packet.h"
#include "io/udp_port.h"
#include "lab/document.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

/// What a message asks of a look: `/afterglow/NAME` and a number, as many as a vector has, or a
/// text as a person would type it.
struct RemoteTurn {
    std::string parameter;
    Value value;
};
Result<RemoteTurn> turn_of(const OscMessage& message, const Look& look);

/// Says which changes that come one by one are one step of undo: those of a parameter with less
/// than half a second between them.
class RemoteGesture {
public:
    /// Whether a change of the parameter now goes on with the step that is open.
    bool goes_on(const std::string& parameter, double now_seconds);
    /// Whether the step that is open has come to its end; told once.
    bool has_ended(double now_seconds);
    bool is_open() const { return !m_touched.empty(); }

private:
    std::map<std::string, double> m_touched;  // when, of the step that is open
};

/// Lets other programs on this machine turn parameters by Open Sound Control.
class OscControl {
public:
    /// 0: listens no more. On failure it does not listen.
    Result<void> listen(int port);
    bool is_listening() const { return m_port.has_value(); }
    /// -1 when it does not listen.
    int descriptor() const { return m_port ? m_port->descriptor() : -1; }
    int port() const { return m_port ? m_port->number() : 0; }

    /// Takes in what has come; null: nothing is open to be turned. `now_seconds` of a clock that
    /// never rests.
    void update(Document* document, double now_seconds);

    /// A step of undo waits for its end.
    bool is_turning() const { return m_gesture.is_open(); }

    std::size_t turned() const { return m_turned; }
    std::size_t refused() const { return m_refused; }
    /// Why the last one was refused; "" for none.
    const std::string& problem() const { return m_problem; }

private:
    void take(const std::vector<std::uint8_t>& packet, Document* document, double now_seconds);
    void refuse(const Diagnostics& reasons);

    std::optional<UdpPort> m_port;
    RemoteGesture m_gesture;
    std::size_t m_turned = 0;   // messages
    std::size_t m_refused = 0;  // packets and messages
    std::string m_problem;
};
