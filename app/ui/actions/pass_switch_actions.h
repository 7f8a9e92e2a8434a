#pragma once

#include "ui/frame/action.h"

/// What the Pass menu switches about the pass that is inspected.
namespace pass_switch_actions {
std::vector<Action> list();
}  // namespace pass_switch_actions
