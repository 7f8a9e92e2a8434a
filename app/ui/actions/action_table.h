#pragma once

#include "ui/frame/action.h"

/// The actions of all menus.
ActionTable make_action_table();
