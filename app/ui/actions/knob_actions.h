#pragma once

#include "ui/frame/action.h"

/// Keyboard actions on the parameter that is revealed in its panel.
namespace knob_actions {
std::vector<Action> list();
}  // namespace knob_actions
