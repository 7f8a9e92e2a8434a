#pragma once

#include "ui/frame/action.h"

/// What compares the picture with another: slots, what the other is, and how the two are seen.
namespace compare_actions {
std::vector<Action> list();
}  // namespace compare_actions
