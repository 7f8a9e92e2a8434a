#pragma once

#include "ui/frame/action.h"

/// Actions of the Pass menu that switch the inspected pass: bypass, freeze, solo, stop.
namespace pass_switch_actions {
std::vector<Action> list();
}  // namespace pass_switch_actions
