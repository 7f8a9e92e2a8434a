#pragma once

#include "ui/frame/action.h"

/// Keyboard actions on the parameter that is revealed in its panel.
namespace parameter_actions {
std::vector<Action> list();
}  // namespace parameter_actions
