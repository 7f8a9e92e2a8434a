#pragma once

#include "base/diagnostic.h"

#include <cstdint>
#include <span>
#include <string>
#include <variant>
#include <vector>

/// An Open Sound Control message from another program: "/afterglow/decay" and its arguments.
struct OscMessage {
    using Argument = std::variant<double, std::string>;  // true and impulse are 1, false is 0

    std::string address;
    std::vector<Argument> arguments;

    bool operator==(const OscMessage&) const = default;
};

/// The messages of a packet in order, including those of bundles; their time tags are ignored.
/// Follows the OpenSound Control Specification 1.0 (M. Wright, 2002), with the types i f s h d S T
/// F I. A packet that is malformed or contains another type is rejected as a whole.
Result<std::vector<OscMessage>> parse_osc(std::span<const std::uint8_t> packet);

/// The packet of one message. Numbers become 32-bit floats; text ends at its first zero byte.
std::vector<std::uint8_t> osc_packet(const OscMessage& message);
