#pragma once

#include "ui/frame/action.h"

/// Actions of the Compare menu: slots, the reference and the compare modes.
namespace compare_actions {
std::vector<Action> list();
}  // namespace compare_actions
