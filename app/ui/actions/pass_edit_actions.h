#pragma once

#include "ui/frame/action.h"

/// Actions that change the passes in the look's files.
namespace pass_edit_actions {
std::vector<Action> list();
}
