#pragma once

#include "ui/frame/action.h"

/// What the Pass menu does, about the pass that is inspected.
namespace pass_actions {
std::vector<Action> list();
}  // namespace pass_actions
