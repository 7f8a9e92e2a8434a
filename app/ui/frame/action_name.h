#pragma once

#include "ui/frame/action.h"

#include <string>
#include <string_view>

/// The name of an action for other programs and for files. It stays when the label changes:
/// "play_pause". That of a panel is "panel_timings".
std::string action_name(const Action& action);

/// The action with that name; null: none.
const Action* find_action(std::string_view name, const ActionTable& actions);

/// The end of the address that runs an action by OSC, and its name in MIDI mappings:
/// "action/play_pause".
std::string action_command(const Action& action);

/// The label of the action that a command runs: "Play or pause". Other commands are their own
/// label.
std::string command_label(std::string_view command, const ActionTable& actions);
