#pragma once

#include "ui/frame/action.h"

/// Actions for displays: the output window and the frame rate limit.
namespace display_actions {
std::vector<Action> list();
}  // namespace display_actions
