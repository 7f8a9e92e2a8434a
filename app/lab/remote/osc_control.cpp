#include "lab/remote/osc_control.h"

#include "lab/document/naming.h"

#include <fmt/format.h>

namespace {
constexpr std::string_view osc_prefix = "/afterglow/";

Result<Value> asked_value(const OscMessage& message, const Parameter& parameter) {
    const auto& arguments = message.arguments;
    if (arguments.size() == 1 && std::holds_alternative<std::string>(arguments.front()))
        return parse_value(parameter, std::get<std::string>(arguments.front()));
    std::vector<double> numbers;
    for (const OscMessage::Argument& argument : arguments)
        if (const auto* number = std::get_if<double>(&argument))
            numbers.push_back(*number);
    const bool is_file = parameter.control == Control::image || parameter.control == Control::sound;
    const auto size = static_cast<std::size_t>(parameter.type.size());
    if (is_file || numbers.size() != arguments.size() || numbers.size() != size)
        return fail({{},
                     0,
                     is_file ? fmt::format("'{}' must be a text", message.address)
                             : wrong_count(message.address, size, arguments.size())});
    return clamped(parameter, Value(std::move(numbers)));
}
}  // namespace

Result<RemoteChange> change_of(const OscMessage& message, const Look& look) {
    if (!message.address.starts_with(osc_prefix))
        return fail({{}, 0, fmt::format("expected /afterglow/NAME, got '{}'", message.address)});
    const auto parameter = resolve_parameter(message.address.substr(osc_prefix.size()), look);
    if (!parameter)
        return fail(parameter.error());
    auto value = asked_value(message, **parameter);
    if (!value)
        return fail(value.error());
    return RemoteChange{(*parameter)->name, std::move(*value)};
}

Result<void> OscControl::listen(int port) {
    m_port.reset();
    m_problem.clear();
    m_applied = m_refused = 0;
    m_messages.clear();
    m_next = 0;
    if (port == 0)
        return {};
    auto opened = UdpPort::open(port);
    if (!opened)
        return fail(opened.error());
    m_port = std::move(*opened);
    return {};
}

void OscControl::refuse(const Diagnostics& reasons) {
    ++m_refused;
    m_problem = reasons.front().message;
}

void OscControl::update(Document* document, RemoteEdits& edits, double now_seconds) {
    if (!m_port)
        return;
    // Per update, so that an endless sender cannot block the picture. A bundle can contain
    // thousands of messages.
    constexpr std::size_t max_packets = 100;
    constexpr std::size_t max_messages = 1000;
    std::size_t packets = 0;
    for (std::size_t messages = 0; messages < max_messages; ++messages) {
        while (m_next == m_messages.size()) {
            const auto packet = packets++ < max_packets ? m_port->take() : std::nullopt;
            if (!packet)
                return;
            read(*packet);
        }
        take(m_messages[m_next++], document, edits, now_seconds);
    }
}

void OscControl::read(const std::vector<std::uint8_t>& packet) {
    m_messages.clear();
    m_next = 0;
    auto messages = parse_osc(packet);
    if (messages)
        m_messages = std::move(*messages);
    else
        refuse(messages.error());
}

void OscControl::take(const OscMessage& message, Document* document, RemoteEdits& edits,
                      double now_seconds) {
    const auto change = document ? change_of(message, document->look())
                                 : fail(Diagnostic{{}, 0, "no look is open"});
    const auto applied =
        change ? edits.apply(*document, *change, now_seconds) : fail(change.error());
    if (applied)
        ++m_applied;
    else
        refuse(applied.error());
}
