#pragma once

#include "io/control/osc_packet.h"
#include "lab/messages/edit.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

using OscArguments = std::vector<OscMessage::Argument>;
using OscMessages = std::vector<OscMessage>;

/// A call of a command by OSC or MIDI.
struct RemoteCall {
    std::string address;  // as received: "/afterglow/command/preset/amber-p3"
    std::string name;     // the text at NAME in the address of the row: "amber-p3"
    const OscArguments& arguments;
    const MutableParts& parts;
};

/// One row of the command table. An address can contain NAME once, which stands for any text.
struct RemoteCommand {
    const char* address;    // after "/afterglow/": "command/preset/NAME"
    const char* arguments;  // for the manual: "NAME [SECONDS]"; "": none
    const char* help;
    /// Returns the replies to the sender, or the reason for a rejection.
    Result<OscMessages> (*run)(const RemoteCall& call);
};

/// The text at NAME if the address is the row's; "" for a row without NAME.
std::optional<std::string> matched_name(std::string_view row_address, std::string_view address);

/// Whether an address without its prefix is reserved for commands and queries.
bool is_command_address(std::string_view address);

/// Runs the row of the message's address. The error of an unknown address has the most similar one.
Result<OscMessages> run_command(const OscMessage& message, std::span<const RemoteCommand> table,
                                const MutableParts& parts);

/// Whether a button was pressed: no argument, a number above 0, or "true". A released button sends
/// 0, which does nothing.
Result<bool> press_of(const OscArguments& arguments);
/// The argument as a number, also if it was sent as text. `what` names it in the error: "SECONDS".
Result<double> number_at(const OscArguments& arguments, std::size_t index, std::string_view what);
