#pragma once

#include "ui/frame/action.h"

/// The rows of all menus.
ActionTable make_action_table();
