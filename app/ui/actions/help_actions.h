#pragma once

#include "ui/frame/action.h"

/// Palette, shortcuts and about.
namespace help_actions {
std::vector<Action> list();
}
