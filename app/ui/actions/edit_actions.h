#pragma once

#include "ui/frame/action.h"

/// Undo, history, drawing, search and remote control.
namespace edit_actions {
std::vector<Action> list();
}
