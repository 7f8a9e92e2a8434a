#pragma once

#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

#include <string>

/// A command that OSC and MIDI can run, and its name for the user.
struct RemoteItem {
    std::string command;  // end of the OSC address: "action/wipe"
    std::string name;     // "Wipe"
};

/// What was chosen in a remote menu.
enum class RemoteChoice { none, learn, other };

/// The right-button menu of the last item: learns or removes the MIDI mapping of a command, and
/// copies its OSC address.
RemoteChoice draw_remote_menu(const RemoteItem& item, const Scene& scene, Edits& edits);
