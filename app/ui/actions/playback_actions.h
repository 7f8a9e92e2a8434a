#pragma once

#include "ui/frame/action.h"

/// Actions of the Playback menu: clock, frame rates, impulse response and automation.
namespace playback_actions {
std::vector<Action> list();
}
