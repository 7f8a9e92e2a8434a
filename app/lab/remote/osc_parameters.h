#pragma once

#include "io/control/osc_packet.h"
#include "lab/remote/remote_edits.h"

#include <string_view>

/// The start of every OSC address.
inline constexpr std::string_view osc_prefix = "/afterglow/";

/// The parameter at an address without its prefix: "decay" or "parameter/decay". Fails with
/// suggestions.
Result<const Parameter*> addressed_parameter(std::string_view address, const Look& look);

/// The value that a message sets: one number per component, or a text as the user would type it.
/// An event without an argument is triggered.
Result<Value> value_from_message(const OscMessage& message, const Parameter& parameter);

/// Parses a message that sets a parameter.
Result<RemoteChange> change_of(const OscMessage& message, const Look& look);

/// The arguments that set a parameter to a value: its numbers, or the name of its file.
std::vector<OscMessage::Argument> arguments_of(const Value& value);
