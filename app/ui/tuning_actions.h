#pragma once

#include "ui/actions.h"

/// What the menus do to many parameters at once.
namespace tuning_actions {
std::vector<Action> list();
}  // namespace tuning_actions
