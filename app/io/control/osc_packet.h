#pragma once

#include "base/diagnostic.h"

#include <cstdint>
#include <span>
#include <string>
#include <variant>
#include <vector>

/// What another program says by Open Sound Control: "/afterglow/decay" and its arguments.
struct OscMessage {
    using Argument = std::variant<double, std::string>;  // true and false are 1 and 0

    std::string address;
    std::vector<Argument> arguments;

    bool operator==(const OscMessage&) const = default;
};

/// The messages of a packet in their order, those of bundles included, whose times are not waited
/// for. After the OpenSound Control Specification 1.0 (M. Wright, 2002), with the types i f s h d T
/// F. One that is malformed, or holds another type, is refused as a whole.
Result<std::vector<OscMessage>> parse_osc(std::span<const std::uint8_t> packet);
