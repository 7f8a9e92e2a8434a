#include "lab/send/retroarch.h"

#include "base/text.h"
#include "io/control/udp_port.h"

#include <fmt/format.h>

namespace {
constexpr std::uint32_t this_machine = 0x7f000001;  // 127.0.0.1
constexpr std::chrono::milliseconds longest_wait{1000};

Result<void> send_text(const UdpPort& from, const std::string& text, int port) {
    return from.send({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()},
                     {this_machine, port});
}

// Whether a packet from that port arrives in time.
bool is_answered(const UdpPort& from, int port) {
    while (const auto packet = from.take_within(longest_wait))
        if (packet->sender.port == port)
            return true;
    return false;
}
}  // namespace

Result<void> load_in_retroarch(const std::filesystem::path& preset, const std::string& port) {
    constexpr int last_port = 65535;
    const auto number = parse_integer(port);
    if (!number || *number < 1 || *number > last_port)
        return fail({{}, 0, fmt::format("'{}' is not a port. Use a number up to 65535.", port)});
    const auto socket = UdpPort::open(0);
    if (!socket)
        return fail(socket.error());
    if (auto asked = send_text(*socket, "VERSION\n", *number); !asked)
        return asked;
    if (!is_answered(*socket, *number))
        return fail(
            {{},
             0,
             fmt::format("RetroArch does not answer on port {}. Enable network commands.", port)});
    return send_text(*socket, fmt::format("SET_SHADER {}\n", preset.string()), *number);
}
