#pragma once

#include "ui/frame/action.h"

/// Actions of the Pass menu on the inspected pass.
namespace pass_actions {
std::vector<Action> list();
}  // namespace pass_actions
