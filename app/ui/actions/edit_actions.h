#pragma once

#include "ui/frame/action.h"

/// Actions of the Edit menu: undo, history, drawing, search and remote control.
namespace edit_actions {
std::vector<Action> list();
}
