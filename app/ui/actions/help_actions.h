#pragma once

#include "ui/frame/action.h"

/// Actions of the Help menu: palette, shortcuts and about.
namespace help_actions {
std::vector<Action> list();
}
