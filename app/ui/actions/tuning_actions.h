#pragma once

#include "ui/frame/action.h"

/// Menu actions on many parameters: filters, step preview and random values.
namespace tuning_actions {
std::vector<Action> list();
}  // namespace tuning_actions
