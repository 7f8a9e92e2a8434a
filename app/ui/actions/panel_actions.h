#pragma once

#include "ui/frame/action.h"

/// Actions that show and hide panels, one for each row of the panel table.
namespace panel_actions {
std::vector<Action> list(Menu menu);
}  // namespace panel_actions
