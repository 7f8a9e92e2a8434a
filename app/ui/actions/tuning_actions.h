#pragma once

#include "ui/frame/action.h"

/// What the menus do to many parameters at once.
namespace tuning_actions {
std::vector<Action> list();
}  // namespace tuning_actions
