#pragma once

#include "lab/remote/remote_command.h"

/// All commands and queries for OSC and MIDI, in the order of the manual.
std::span<const RemoteCommand> remote_commands();
