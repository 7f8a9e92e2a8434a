#pragma once

#include "ui/frame/action.h"

/// The clock, frame rates, impulse response and automation.
namespace playback_actions {
std::vector<Action> list();
}
