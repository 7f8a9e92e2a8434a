#pragma once

#include "ui/frame/action.h"

/// What the View menu does with displays: the output window, and how many frames are drawn.
namespace display_actions {
std::vector<Action> list();
}  // namespace display_actions
